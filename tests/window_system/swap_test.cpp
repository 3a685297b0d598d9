// What a swap leaves in the back buffer of a real window: trails, drawn by GLX and by EGL.

#include "tests/window_system/glx_fixture.h"

#include <cstdlib>
#include <string>

#include <EGL/egl.h>

namespace ffgpu::tests {
namespace {

constexpr int Columns = 6;
constexpr unsigned Width = 8 * Columns, Height = 16;

// What `ffgpu run --swap exchange` sets.
struct Exchange {
    Exchange() { ::setenv("FFGPU_SWAP", "exchange", 1); }
    ~Exchange() { ::unsetenv("FFGPU_SWAP"); }
};

// A frame draws a white column over what is there.
void draw_column(int column) {
    glEnable(GL_SCISSOR_TEST);
    glScissor(8 * column, 0, 8, Height);
    glClearColor(1, 1, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glDisable(GL_SCISSOR_TEST);
}

template <class Swap>
std::string trails(const TestWindow& window, Swap&& swap) {
    for (int column = 0; column < 4; ++column) {
        draw_column(column);
        swap();
    }
    std::string seen;
    for (int column = 0; column < Columns; ++column)
        seen += window.pixel(8 * column + 4, 8) == 0xffffff ? '#' : '.';
    return seen;
}

std::string glx_trails(Display* display) {
    const GLXFBConfig config = choose(display, true);
    const TestWindow window(display, config, Width, Height);
    const GLXContext context = glXCreateNewContext(display, config, GLX_RGBA_TYPE, nullptr, True);
    REQUIRE(glXMakeCurrent(display, window.id(), context));
    std::string seen = trails(window, [&] { glXSwapBuffers(display, window.id()); });
    glXMakeCurrent(display, 0, nullptr);
    glXDestroyContext(display, context);
    return seen;
}

int swap_method(Display* display, bool double_buffer) {
    constexpr int SwapMethod = 0x8060; // GLX_SWAP_METHOD_OML
    int value = -1;
    CHECK(glXGetFBConfigAttrib(display, choose(display, double_buffer), SwapMethod, &value) == 0);
    return value;
}

struct EglWindow {
    explicit EglWindow(Display* native)
        : display(eglGetDisplay(native)) {
        REQUIRE(eglInitialize(display, nullptr, nullptr));
        REQUIRE(eglBindAPI(EGL_OPENGL_API));
        const EGLint wish[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
        EGLint count = 0;
        REQUIRE(eglChooseConfig(display, wish, &config, 1, &count));
        REQUIRE(count == 1);
        XVisualInfo wanted{};
        EGLint visual = 0;
        REQUIRE(eglGetConfigAttrib(display, config, EGL_NATIVE_VISUAL_ID, &visual));
        wanted.visualid = static_cast<VisualID>(visual);
        int found = 0;
        XVisualInfo* const visuals = XGetVisualInfo(native, VisualIDMask, &wanted, &found);
        REQUIRE(found > 0);
        window = std::make_unique<TestWindow>(native, *visuals, Width, Height);
        XFree(visuals);
        surface = eglCreateWindowSurface(display, config, window->id(), nullptr);
        context = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
        REQUIRE(eglMakeCurrent(display, surface, surface, context));
    }
    ~EglWindow() {
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroySurface(display, surface);
        eglDestroyContext(display, context);
    }
    EglWindow(const EglWindow&) = delete;
    EglWindow& operator=(const EglWindow&) = delete;

    EGLint behavior() const {
        EGLint value = 0;
        CHECK(eglQuerySurface(display, surface, EGL_SWAP_BEHAVIOR, &value));
        return value;
    }
    bool may_preserve() const {
        EGLint types = 0;
        CHECK(eglGetConfigAttrib(display, config, EGL_SURFACE_TYPE, &types));
        return (types & EGL_SWAP_BEHAVIOR_PRESERVED_BIT) != 0;
    }
    std::string draw_trails() const {
        return trails(*window, [&] { CHECK(eglSwapBuffers(display, surface)); });
    }

    EGLDisplay display;
    EGLConfig config = nullptr;
    std::unique_ptr<TestWindow> window;
    EGLSurface surface = EGL_NO_SURFACE;
    EGLContext context = EGL_NO_CONTEXT;
};

TEST_CASE("a GLX program may draw over its last frame") {
    Display* const display = XServer::display();
    if (!display) return;
    CHECK(glx_trails(display) == "####..");
    CHECK(swap_method(display, true) == 0x8062);  // GLX_SWAP_COPY_OML
    CHECK(swap_method(display, false) == 0x8063); // GLX_SWAP_UNDEFINED_OML
    const Exchange exchange;
    CHECK(glx_trails(display) == ".#.#..");
    CHECK(swap_method(display, true) == 0x8061); // GLX_SWAP_EXCHANGE_OML
}

TEST_CASE("an EGL program may draw over its last frame") {
    Display* const display = XServer::display();
    if (!display) return;
    {
        const EglWindow window(display);
        CHECK(window.draw_trails() == "####..");
        CHECK(window.behavior() == EGL_BUFFER_PRESERVED);
        CHECK(window.may_preserve());
        CHECK(eglSurfaceAttrib(
            window.display, window.surface, EGL_SWAP_BEHAVIOR, EGL_BUFFER_DESTROYED));
        CHECK(window.behavior() == EGL_BUFFER_DESTROYED);
        CHECK_FALSE(eglSurfaceAttrib(window.display, window.surface, EGL_SWAP_BEHAVIOR, 1));
        CHECK(eglGetError() == EGL_BAD_PARAMETER);
    }
    const Exchange exchange;
    const EglWindow window(display);
    CHECK(window.draw_trails() == ".#.#..");
    CHECK(window.behavior() == EGL_BUFFER_DESTROYED);
    CHECK_FALSE(window.may_preserve());
    CHECK_FALSE(
        eglSurfaceAttrib(window.display, window.surface, EGL_SWAP_BEHAVIOR, EGL_BUFFER_PRESERVED));
    CHECK(eglGetError() == EGL_BAD_MATCH);
}

} // namespace
} // namespace ffgpu::tests
