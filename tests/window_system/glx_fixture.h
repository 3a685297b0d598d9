// A window with a context on the tests' X server.

#pragma once

#include "tests/window_system/x_server.h"

#include <array>
#include <memory>

#include <GL/gl.h>
#include <GL/glx.h>
#include <X11/Xutil.h>

namespace ffgpu::tests {

inline GLXFBConfig choose(Display* display, bool double_buffer) {
    const int wish[] = {GLX_DOUBLEBUFFER, double_buffer, GLX_DEPTH_SIZE, 16, 0};
    int count = 0;
    GLXFBConfig* const found = glXChooseFBConfig(display, 0, wish, &count);
    REQUIRE(count > 0);
    const GLXFBConfig best = found[0];
    XFree(found);
    return best;
}

class TestWindow {
public:
    TestWindow(Display* display, const XVisualInfo& visual, unsigned width, unsigned height)
        : display_(display) {
        XSetWindowAttributes attributes{};
        attributes.colormap =
            XCreateColormap(display, RootWindow(display, 0), visual.visual, AllocNone);
        window_ = XCreateWindow(display,
                                RootWindow(display, 0),
                                0,
                                0,
                                width,
                                height,
                                0,
                                visual.depth,
                                InputOutput,
                                visual.visual,
                                CWColormap | CWBorderPixel,
                                &attributes);
        XMapWindow(display, window_);
        XSync(display, False);
    }
    TestWindow(Display* display, GLXFBConfig config, unsigned width, unsigned height)
        : TestWindow(display, *visual_of(display, config), width, height) {}
    ~TestWindow() { XDestroyWindow(display_, window_); }
    TestWindow(const TestWindow&) = delete;
    TestWindow& operator=(const TestWindow&) = delete;

    Window id() const { return window_; }

    // What the screen shows: red << 16 | green << 8 | blue; y from the top.
    unsigned long pixel(int x, int y) const {
        XImage* const image = XGetImage(display_, window_, x, y, 1, 1, AllPlanes, ZPixmap);
        const unsigned long value = XGetPixel(image, 0, 0) & 0xffffff;
        XDestroyImage(image);
        return value;
    }

private:
    struct Free {
        void operator()(XVisualInfo* visual) const { XFree(visual); }
    };
    static std::unique_ptr<XVisualInfo, Free> visual_of(Display* display, GLXFBConfig config) {
        return std::unique_ptr<XVisualInfo, Free>(glXGetVisualFromFBConfig(display, config));
    }

    Display* display_;
    Window window_ = 0;
};

inline std::array<GLubyte, 4> read_pixel(int x, int y) {
    std::array<GLubyte, 4> pixel{};
    glReadPixels(x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
    return pixel;
}

} // namespace ffgpu::tests
