// Programs that set their thread's floating-point mode: they get the same frames, and find their
// mode again.

#include "tests/window_system/glx_fixture.h"

#include <cfenv>
#include <functional>
#include <vector>

#ifdef __SSE__
#include <xmmintrin.h>
#endif

namespace ffgpu::tests {
namespace {

constexpr int Size = 64;

struct StripVertex {
    float x, y, z, green;
};

// More than the buffer of vertices takes. Made when no mode is set yet.
const std::vector<StripVertex>& long_strip() {
    static const std::vector<StripVertex> strip = [] {
        std::vector<StripVertex> vertices;
        for (int i = 0; i < 70000; ++i)
            vertices.push_back({static_cast<float>(i % 997) / 90 - 5,
                                static_cast<float>(i % 83) / 9 - 4,
                                static_cast<float>(i % 7) / 3 - 9,
                                static_cast<float>(i % 101) / 100});
        return vertices;
    }();
    return strip;
}

// By calls that only move numbers, behind a matrix that is not in the device yet: one of them finds
// the buffer full, and draws. A subnormal attribute enters late.
void draw_long_strip(const std::function<void()>& between) {
    glPushMatrix();
    glRotatef(11.3f, 0.1f, 0.7f, 1);
    glBegin(GL_TRIANGLE_STRIP);
    for (const StripVertex& vertex : long_strip()) {
        glColor3f(0.9f, vertex.green, 0.3f);
        if (&vertex != long_strip().data()) glMultiTexCoord2fARB(GL_TEXTURE0, vertex.x, 1e-39f);
        glVertex3f(vertex.x, vertex.y, vertex.z);
    }
    between();
    glEnd();
    glPopMatrix();
}

// Lights, a texture, fog, a slanted plane: most of what computes. Its inputs are constants.
std::vector<GLubyte> draw_scene(const std::function<void()>& between) {
    static const GLubyte texels[] = {255, 0, 40, 90, 200, 10, 33, 177, 4, 99, 250, 128};
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 2, 2, 0, GL_RGB, GL_UNSIGNED_BYTE, texels);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    between();
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glFrustum(-1, 1, -1, 1, 1, 30);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glTranslatef(0.1f, -0.3f, -3.3f);
    glRotatef(37.7f, 1, 0.3f, 0.2f);
    glScalef(1e-20f, 1, 1); // subnormals come into reach
    glScalef(1e20f, 1, 1);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_COLOR_MATERIAL);
    glEnable(GL_NORMALIZE);
    glEnable(GL_TEXTURE_2D);
    glEnable(GL_FOG);
    glFogf(GL_FOG_DENSITY, 0.17f);
    between();
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glBegin(GL_TRIANGLE_FAN);
    for (int i = 0; i < 40; ++i) {
        between();
        const int x = i * i % 41 - 20, y = i * 7 % 37 - 18;
        glColor3ub(static_cast<GLubyte>(6 * i), 200, static_cast<GLubyte>(255 - 3 * i));
        glNormal3i(x << 20, y << 20, 1 << 27);
        glTexCoord2i(x, y);
        glVertex3s(static_cast<GLshort>(x), static_cast<GLshort>(y), static_cast<GLshort>(i % 3));
    }
    glEnd();
    draw_long_strip(between);
    std::vector<GLubyte> pixels(4 * Size * Size);
    glReadPixels(0, 0, Size, Size, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    CHECK(glGetError() == GL_NO_ERROR);
    return pixels;
}

std::vector<GLubyte> picture_with(Display* display, const std::function<void()>& between) {
    const GLXFBConfig config = choose(display, true);
    const TestWindow window(display, config, Size, Size);
    const GLXContext context = glXCreateNewContext(display, config, GLX_RGBA_TYPE, nullptr, True);
    REQUIRE(glXMakeCurrent(display, window.id(), context));
    std::vector<GLubyte> pixels = draw_scene(between);
    glXSwapBuffers(display, window.id());
    glXMakeCurrent(display, 0, nullptr);
    glXDestroyContext(display, context);
    return pixels;
}

} // namespace

TEST_CASE("a rounding mode of the program's changes no picture, and stays the program's") {
    Display* const display = XServer::display();
    if (!display) return;
    const std::vector<GLubyte> expected = picture_with(display, [] {});
    CHECK(std::vector<GLubyte>(expected.size()) != expected);
    for (const int mode : {FE_TOWARDZERO, FE_UPWARD, FE_DOWNWARD}) {
        std::fesetround(mode);
        const std::vector<GLubyte> drawn =
            picture_with(display, [mode] { CHECK(std::fegetround() == mode); });
        const int found = std::fegetround();
        std::fesetround(FE_TONEAREST);
        CHECK(found == mode);
        CHECK(drawn == expected);
    }
}

#ifdef __SSE__
TEST_CASE("a program that flushes subnormals to zero, or traps, gets the same picture") {
    Display* const display = XServer::display();
    if (!display) return;
    const std::vector<GLubyte> expected = picture_with(display, [] {});
    constexpr unsigned Mode = 0xffc0, Usual = 0x1f80;
    // Flush-to-zero with denormals-are-zero, as -ffast-math sets them; traps on inexact results.
    for (const unsigned control : {0x9fc0u, 0x0f80u, 0xffc0u}) {
        const std::vector<GLubyte> drawn = picture_with(display, [control] {
            const unsigned found = _mm_getcsr() & Mode;
            _mm_setcsr(Usual);
            if (found != Usual) CHECK(found == control);
            _mm_setcsr(control);
        });
        const unsigned found = _mm_getcsr() & Mode;
        _mm_setcsr(Usual);
        CHECK(found == control);
        CHECK(drawn == expected);
    }
}
#endif

} // namespace ffgpu::tests
