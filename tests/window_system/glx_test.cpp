// GLX on a real X server.

#include "tests/window_system/glx_fixture.h"

#include <thread>
#include <vector>

namespace ffgpu::tests {
namespace {

int value_of(Display* display, GLXFBConfig config, int attribute) {
    int value = -1;
    CHECK(glXGetFBConfigAttrib(display, config, attribute, &value) == 0);
    return value;
}

void fill(float red, float green, float blue) {
    glClearColor(red, green, blue, 1);
    glClear(GL_COLOR_BUFFER_BIT);
}

TEST_CASE("a swap shows the back buffer, right side up") {
    Display* const display = XServer::display();
    if (!display) return;
    const GLXFBConfig config = choose(display, true);
    const TestWindow window(display, config, 64, 48);
    const GLXContext context = glXCreateNewContext(display, config, GLX_RGBA_TYPE, nullptr, True);
    REQUIRE(glXMakeCurrent(display, window.id(), context));
    fill(0, 0, 1);
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, 64, 12); // the lowest rows
    fill(1, 0.5f, 0);
    const auto low = read_pixel(3, 3), high = read_pixel(3, 40);
    CHECK(low == std::array<GLubyte, 4>{255, 128, 0, 255});
    CHECK(window.pixel(3, 44) != 0xff8000);
    glXSwapBuffers(display, window.id());
    CHECK(window.pixel(3, 44) == 0xff8000);
    CHECK(window.pixel(3, 35) == 0x0000ff); // the row above the border
    CHECK(window.pixel(3, 36) == 0xff8000);
    CHECK(high == std::array<GLubyte, 4>{0, 0, 255, 255});
    CHECK(glGetError() == GL_NO_ERROR);
    glXMakeCurrent(display, 0, nullptr);
    glXDestroyContext(display, context);
}

TEST_CASE("single-buffered drawing shows at glFlush and not before") {
    Display* const display = XServer::display();
    if (!display) return;
    const GLXFBConfig config = choose(display, false);
    const TestWindow window(display, config, 32, 32);
    const GLXContext context = glXCreateNewContext(display, config, GLX_RGBA_TYPE, nullptr, True);
    REQUIRE(glXMakeCurrent(display, window.id(), context));
    fill(0, 1, 0);
    glFlush();
    CHECK(window.pixel(5, 5) == 0x00ff00);
    fill(1, 0, 0);
    CHECK(window.pixel(5, 5) == 0x00ff00);
    glFinish();
    CHECK(window.pixel(5, 5) == 0xff0000);
    glXMakeCurrent(display, 0, nullptr);
    glXDestroyContext(display, context);
}

TEST_CASE("a window that grew is drawn in its new size once the viewport is set") {
    Display* const display = XServer::display();
    if (!display) return;
    const GLXFBConfig config = choose(display, true);
    const TestWindow window(display, config, 32, 32);
    const GLXContext context = glXCreateNewContext(display, config, GLX_RGBA_TYPE, nullptr, True);
    REQUIRE(glXMakeCurrent(display, window.id(), context));
    fill(0, 0, 1);
    glXSwapBuffers(display, window.id());
    XResizeWindow(display, window.id(), 80, 60);
    XSync(display, False);
    glViewport(0, 0, 80, 60);
    fill(1, 0, 0);
    glXSwapBuffers(display, window.id());
    CHECK(window.pixel(79, 0) == 0xff0000);
    CHECK(window.pixel(79, 59) == 0xff0000);
    unsigned width = 0;
    glXQueryDrawable(display, window.id(), GLX_WIDTH, &width);
    CHECK(width == 80);
    glXMakeCurrent(display, 0, nullptr);
    glXDestroyContext(display, context);
}

TEST_CASE("configurations come in GLX's order") {
    Display* const display = XServer::display();
    if (!display) return;
    const auto choose_all = [&](std::vector<int> wish) {
        wish.push_back(0);
        int count = 0;
        GLXFBConfig* const found = glXChooseFBConfig(display, 0, wish.data(), &count);
        std::vector<GLXFBConfig> list(found, found + count);
        if (found) XFree(found);
        return list;
    };
    const auto any = choose_all({});
    REQUIRE(any.size() > 1);
    CHECK(value_of(display, any[0], GLX_DOUBLEBUFFER) == False); // single before double
    CHECK(value_of(display, any[0], GLX_DEPTH_SIZE) == 0);       // none where none is asked for
    CHECK(value_of(display, any[0], GLX_ALPHA_SIZE) == 0);       // fewer bits in all
    const auto deep = choose_all({GLX_DEPTH_SIZE, 1});
    CHECK(value_of(display, deep[0], GLX_DEPTH_SIZE) == 24); // the most where some are
    CHECK(value_of(display, deep[0], GLX_STENCIL_SIZE) == 0);
    const auto alpha = choose_all({GLX_ALPHA_SIZE, 1, GLX_DOUBLEBUFFER, True});
    for (const GLXFBConfig config : alpha)
        CHECK(value_of(display, config, GLX_ALPHA_SIZE) == 8);
    CHECK(choose_all({GLX_STEREO, True}).empty());
    CHECK(choose_all({GLX_RED_SIZE, 9}).empty());
}

TEST_CASE("what glXChooseVisual finds is what it was asked for") {
    Display* const display = XServer::display();
    if (!display) return;
    for (const bool twice : {false, true}) {
        std::vector<int> wish{GLX_RGBA, GLX_DEPTH_SIZE, 16, GLX_ACCUM_RED_SIZE, 8};
        if (twice) wish.push_back(GLX_DOUBLEBUFFER);
        wish.push_back(0);
        XVisualInfo* const visual = glXChooseVisual(display, 0, wish.data());
        REQUIRE(visual);
        int value = -1;
        CHECK(glXGetConfig(display, visual, GLX_DOUBLEBUFFER, &value) == 0);
        CHECK(value == twice);
        CHECK(glXGetConfig(display, visual, GLX_ACCUM_RED_SIZE, &value) == 0);
        CHECK(value == 16);
        XFree(visual);
    }
    int index[] = {GLX_BUFFER_SIZE, 8, 0}; // No colour-index visuals.
    CHECK(glXChooseVisual(display, 0, index) == nullptr);
}

TEST_CASE("configurations say that their buffers can hold sRGB codes, wanted or not") {
    Display* const display = XServer::display();
    if (!display) return;
    int count = 0;
    for (const int wish : {False, True}) {
        const int list[] = {GLX_FRAMEBUFFER_SRGB_CAPABLE_ARB, wish, 0};
        GLXFBConfig* const configs =
            glXChooseFBConfig(display, DefaultScreen(display), list, &count);
        REQUIRE(count > 0);
        int value = -1;
        CHECK(glXGetFBConfigAttrib(display, configs[0], GLX_FRAMEBUFFER_SRGB_CAPABLE_ARB, &value) ==
              0);
        CHECK(value == True);
        XFree(configs);
    }
    int attributes[] = {GLX_RGBA, GLX_FRAMEBUFFER_SRGB_CAPABLE_ARB, True, 0};
    XVisualInfo* const visual = glXChooseVisual(display, DefaultScreen(display), attributes);
    REQUIRE(visual);
    XFree(visual);
}

TEST_CASE("contexts share textures only where they are told to") {
    Display* const display = XServer::display();
    if (!display) return;
    const GLXFBConfig config = choose(display, true);
    const TestWindow window(display, config, 8, 8);
    const auto make = [&](GLXContext share) {
        return glXCreateNewContext(display, config, GLX_RGBA_TYPE, share, True);
    };
    const GLXContext first = make(nullptr);
    const GLXContext shared = make(first), alone = make(nullptr);
    glXMakeCurrent(display, window.id(), first);
    glBindTexture(GL_TEXTURE_2D, 7);
    glNewList(3, GL_COMPILE);
    glEndList();
    glXMakeCurrent(display, window.id(), shared);
    CHECK(glIsTexture(7));
    CHECK(glIsList(3));
    glXMakeCurrent(display, window.id(), alone);
    CHECK_FALSE(glIsTexture(7));
    CHECK_FALSE(glIsList(3));
    glXMakeCurrent(display, 0, nullptr);
    for (const GLXContext context : {first, shared, alone})
        glXDestroyContext(display, context);
}

TEST_CASE("glXCopyContext copies the groups of its mask and no others") {
    Display* const display = XServer::display();
    if (!display) return;
    const GLXFBConfig config = choose(display, true);
    const TestWindow window(display, config, 8, 8);
    const GLXContext from = glXCreateNewContext(display, config, GLX_RGBA_TYPE, nullptr, True);
    const GLXContext to = glXCreateNewContext(display, config, GLX_RGBA_TYPE, nullptr, True);
    glXMakeCurrent(display, window.id(), from);
    glDepthFunc(GL_GREATER);
    glPointSize(4);
    glXCopyContext(display, from, to, GL_DEPTH_BUFFER_BIT);
    glXMakeCurrent(display, window.id(), to);
    GLint function = 0;
    GLfloat size = 0;
    glGetIntegerv(GL_DEPTH_FUNC, &function);
    glGetFloatv(GL_POINT_SIZE, &size);
    CHECK(function == GL_GREATER);
    CHECK(size == 1);
    glXMakeCurrent(display, 0, nullptr);
    glXDestroyContext(display, from);
    glXDestroyContext(display, to);
}

// Each thread draws its own colours into its own buffer; all draw on one device.
void draw_and_check(Display* display, GLXFBConfig config, int seed, int& wrong) {
    const int size[] = {GLX_PBUFFER_WIDTH, 16, GLX_PBUFFER_HEIGHT, 16, 0};
    const GLXPbuffer buffer = glXCreatePbuffer(display, config, size);
    const GLXContext context = glXCreateNewContext(display, config, GLX_RGBA_TYPE, nullptr, True);
    glXMakeCurrent(display, buffer, context);
    for (int i = 0; i < 200; ++i) {
        const auto red = static_cast<GLubyte>(i), green = static_cast<GLubyte>(seed);
        glColor3ub(red, green, 9);
        glBegin(GL_QUADS);
        glVertex2f(-1, -1);
        glVertex2f(1, -1);
        glVertex2f(1, 1);
        glVertex2f(-1, 1);
        glEnd();
        wrong += read_pixel(i % 16, seed % 16) != std::array<GLubyte, 4>{red, green, 9, 255};
    }
    glXMakeCurrent(display, 0, nullptr);
    glXDestroyContext(display, context);
    glXDestroyPbuffer(display, buffer);
}

TEST_CASE("several threads draw at once, each in a context of its own") {
    Display* const display = XServer::display();
    if (!display) return;
    const GLXFBConfig config = choose(display, true);
    std::array<int, 3> wrong{};
    std::vector<std::thread> threads;
    for (std::size_t i = 0; i < wrong.size(); ++i)
        threads.emplace_back(
            [&, i] { draw_and_check(display, config, 50 + static_cast<int>(i), wrong[i]); });
    for (std::thread& thread : threads)
        thread.join();
    CHECK(wrong == std::array<int, 3>{});
}

TEST_CASE("a context is current in one thread at a time") {
    Display* const display = XServer::display();
    if (!display) return;
    const GLXFBConfig config = choose(display, true);
    const TestWindow window(display, config, 8, 8);
    const GLXContext context = glXCreateNewContext(display, config, GLX_RGBA_TYPE, nullptr, True);
    REQUIRE(glXMakeCurrent(display, window.id(), context));
    static int error_code;
    error_code = 0;
    const auto before = XSetErrorHandler([](Display*, XErrorEvent* error) {
        error_code = error->error_code;
        return 0;
    });
    Bool taken = True;
    std::thread([&] { taken = glXMakeCurrent(display, window.id(), context); }).join();
    XSetErrorHandler(before);
    CHECK_FALSE(taken);
    CHECK(error_code == BadAccess);
    glXMakeCurrent(display, 0, nullptr);
    glXDestroyContext(display, context);
}

} // namespace
} // namespace ffgpu::tests
