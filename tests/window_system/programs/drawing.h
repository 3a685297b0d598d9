// For the programs that tests start: a window with a context that is current; pictures on it.

#pragma once

#include <GL/gl.h>
#include <GL/glx.h>

namespace ffgpu::tests {

inline Window make_window(Display* display, const XVisualInfo& visual, unsigned size) {
    XSetWindowAttributes attributes{};
    const Window root = RootWindow(display, visual.screen);
    attributes.colormap = XCreateColormap(display, root, visual.visual, AllocNone);
    const Window window = XCreateWindow(display,
                                        root,
                                        0,
                                        0,
                                        size,
                                        size,
                                        0,
                                        visual.depth,
                                        InputOutput,
                                        visual.visual,
                                        CWColormap,
                                        &attributes);
    XMapWindow(display, window);
    return window;
}

class Drawing {
public:
    explicit Drawing(unsigned size = 64) {
        int attributes[] = {GLX_RGBA, GLX_DOUBLEBUFFER, GLX_DEPTH_SIZE, 16, None};
        XVisualInfo* const visual = glXChooseVisual(display, DefaultScreen(display), attributes);
        window_ = make_window(display, *visual, size);
        glXMakeCurrent(display, window_, glXCreateContext(display, visual, nullptr, True));
    }
    // Another red for each number.
    void frame(int number) const {
        glClearColor(static_cast<float>(number) / 10, 0, 0, 1);
        glClear(GL_COLOR_BUFFER_BIT);
        swap();
    }
    void swap() const { glXSwapBuffers(display, window_); }

    Display* const display = XOpenDisplay(nullptr);

private:
    Window window_;
};

} // namespace ffgpu::tests
