// A GLX program that draws ten frames and forks children which end by exit(): one before the first
// frame, that lives on while frames are drawn, and one between two frames.

#include <cstdlib>

#include <GL/gl.h>
#include <GL/glx.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

constexpr int Frames = 10, ForkAfter = 4;

Window make_window(Display* display, const XVisualInfo& visual) {
    XSetWindowAttributes attributes{};
    const Window root = RootWindow(display, visual.screen);
    attributes.colormap = XCreateColormap(display, root, visual.visual, AllocNone);
    const Window window = XCreateWindow(display,
                                        root,
                                        0,
                                        0,
                                        64,
                                        64,
                                        0,
                                        visual.depth,
                                        InputOutput,
                                        visual.visual,
                                        CWColormap,
                                        &attributes);
    XMapWindow(display, window);
    return window;
}

} // namespace

int main(int count, char**) {
    Display* const display = XOpenDisplay(nullptr);
    int attributes[] = {GLX_RGBA, GLX_DOUBLEBUFFER, GLX_DEPTH_SIZE, 16, None};
    XVisualInfo* const visual = glXChooseVisual(display, DefaultScreen(display), attributes);
    const Window window = make_window(display, *visual);
    glXMakeCurrent(display, window, glXCreateContext(display, visual, nullptr, True));

    int ends[2];
    if (::pipe(ends) != 0) return 2;
    const pid_t early = ::fork();
    if (early == 0) {
        ::close(ends[1]);
        char none = 0;
        const bool parent_is_done = ::read(ends[0], &none, 1) == 0;
        std::exit(parent_is_done ? EXIT_SUCCESS : EXIT_FAILURE);
    }
    for (int i = 0; i < Frames; ++i) {
        glClearColor(static_cast<float>(i) / Frames, 0, 0, 1);
        glClear(GL_COLOR_BUFFER_BIT);
        glXSwapBuffers(display, window);
        if (i != ForkAfter) continue;
        const pid_t child = ::fork();
        if (child == 0) std::exit(EXIT_SUCCESS);
        ::waitpid(child, nullptr, 0);
    }
    ::close(ends[1]);
    int status = 0;
    for (XEvent event; count > 1;)
        XNextEvent(display, &event);
    ::waitpid(early, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : EXIT_FAILURE;
}
