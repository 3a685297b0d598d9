// glXUseXFont: display lists that draw what X draws with the font.

#define GL_GLEXT_PROTOTYPES

#include "tests/window_system/glx_fixture.h"

#include <vector>

namespace ffgpu::tests {
namespace {

constexpr int Width = 64, Height = 48;

// Row by row from the top, as X draws the text with its baseline at (x, y).
std::vector<bool>
drawn_by_x(Display* display, Window window, Font font, const char* text, int x, int y) {
    const Pixmap pixmap = XCreatePixmap(display, window, Width, Height, 1);
    XGCValues values{};
    values.font = font;
    const GC graphics = XCreateGC(display, pixmap, GCFont, &values);
    XSetForeground(display, graphics, 0);
    XFillRectangle(display, pixmap, graphics, 0, 0, Width, Height);
    XSetForeground(display, graphics, 1);
    XDrawString(display, pixmap, graphics, x, y, text, 2);
    XImage* const image = XGetImage(display, pixmap, 0, 0, Width, Height, 1, XYPixmap);
    std::vector<bool> pixels;
    for (int row = 0; row < Height; ++row)
        for (int column = 0; column < Width; ++column)
            pixels.push_back(XGetPixel(image, column, row) != 0);
    XDestroyImage(image);
    XFreeGC(display, graphics);
    XFreePixmap(display, pixmap);
    return pixels;
}

TEST_CASE("lists of an X font draw its glyphs, whatever the pixel store holds") {
    Display* const display = XServer::display();
    if (!display) return;
    XFontStruct* const font = XLoadQueryFont(display, "fixed");
    if (!font) return;
    const GLXFBConfig config = choose(display, true);
    const TestWindow window(display, config, Width, Height);
    const GLXContext context = glXCreateNewContext(display, config, GLX_RGBA_TYPE, nullptr, True);
    REQUIRE(glXMakeCurrent(display, window.id(), context));
    GLuint buffer = 0;
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, buffer);
    glPixelStorei(GL_UNPACK_LSB_FIRST, GL_TRUE);
    glXUseXFont(font->fid, 'a', 26, 100);
    GLint bound = 0, lsb_first = 0;
    glGetIntegerv(GL_PIXEL_UNPACK_BUFFER_BINDING, &bound);
    glGetIntegerv(GL_UNPACK_LSB_FIRST, &lsb_first);
    CHECK(bound == static_cast<GLint>(buffer));
    CHECK(lsb_first == GL_TRUE);

    glOrtho(0, Width, 0, Height, -1, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glRasterPos2i(10, 20);
    glCallList(100 + 'g' - 'a');
    glCallList(100 + 'f' - 'a');
    std::vector<bool> pixels;
    for (int y = Height - 1; y >= 0; --y)
        for (int x = 0; x < Width; ++x)
            pixels.push_back(read_pixel(x, y)[0] != 0);
    const auto expected = drawn_by_x(display, window.id(), font->fid, "gf", 10, Height - 20);
    CHECK(pixels == expected);
    GLfloat position[4] = {};
    glGetFloatv(GL_CURRENT_RASTER_POSITION, position);
    CHECK(position[0] == 10.0f + static_cast<float>(XTextWidth(font, "gf", 2)));
    CHECK(glGetError() == GL_NO_ERROR);

    glXMakeCurrent(display, 0, nullptr);
    glXDestroyContext(display, context);
    XFreeFont(display, font);
}

} // namespace
} // namespace ffgpu::tests
