// A GLX program whose frames never end well. "noise": pictures that take long to write, and while
// they are written children that call exit(). "killed": ten frames, another one later, then
// SIGKILL. "endless": frames until somebody ends it. "later": asks for contexts of OpenGL 3.3 and
// 2.1, and draws a frame on an older one. "leak WHAT": endless, and loses a little of WHAT.
// "abandon": a frame, then _exit(4). "become": a frame, then this program again as "abandon".
// "last": a frame, and another one from an exit handler; "early": from one registered before the
// context was made. "daemon": a frame, then _exit(4), and two more from a forked child. "quick":
// three frames, then quick_exit(5). "starved": a frame where no memory is
// left. "attach": tells its process, and is killed where the server is to share memory for a frame.

// glXCreateContextAttribsARB is declared only then.
#define GLX_GLXEXT_PROTOTYPES

#include "tests/window_system/programs/drawing.h"

#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include <GL/glxext.h>
#include <X11/extensions/XShm.h>
#include <dlfcn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

using ffgpu::tests::Drawing;

constexpr unsigned Size = 200;

void noise() {
    const Drawing drawing(Size);
    std::vector<std::uint8_t> pixels(4 * Size * Size);
    std::uint32_t state = 1;
    for (int frame = 0; frame < 40; ++frame) {
        for (std::uint8_t& value : pixels) {
            state = state * 1664525u + 1013904223u;
            value = static_cast<std::uint8_t>(state >> 24);
        }
        glDrawPixels(Size, Size, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
        drawing.swap();
        for (int child = 0; child < 6; ++child) {
            ::usleep(700);
            const pid_t process = ::fork();
            if (process == 0) std::exit(EXIT_SUCCESS);
            ::waitpid(process, nullptr, 0);
        }
    }
}

void killed() {
    const Drawing drawing;
    for (int frame = 0; frame < 10; ++frame)
        drawing.frame(frame);
    ::usleep(1'500'000); // More than statistics may be old.
    drawing.frame(10);
    std::raise(SIGKILL);
}

void endless() {
    const Drawing drawing;
    for (int frame = 0;; ++frame) {
        drawing.frame(frame % 10);
        ::usleep(1000);
    }
}

// Four KiB of memory each frame, or a descriptor or pixmap each hundredth.
void leak(const std::string& what) {
    const Drawing drawing;
    for (int frame = 0;; ++frame) {
        drawing.frame(frame % 10);
        const bool is_hundredth = frame % 100 == 0;
        if (what == "memory") static_cast<volatile char*>(std::calloc(1, 4096))[0] = 1;
        // The memory of the line before is to be found by others than the analyzer.
        // NOLINTNEXTLINE(clang-analyzer-unix.Malloc)
        if (what == "descriptor" && is_hundredth && ::dup(STDERR_FILENO) < 0) return;
        if (what == "pixmap" && is_hundredth)
            XCreatePixmap(drawing.display, DefaultRootWindow(drawing.display), 8, 8, 24);
    }
}

void later() {
    Display* const display = XOpenDisplay(nullptr);
    int count = 0;
    GLXFBConfig* const configs =
        glXChooseFBConfig(display, DefaultScreen(display), nullptr, &count);
    XSetErrorHandler([](Display*, XErrorEvent*) { return 0; });
    for (const int major : {3, 2}) {
        const int wish[] = {GLX_CONTEXT_MAJOR_VERSION_ARB,
                            major,
                            GLX_CONTEXT_MINOR_VERSION_ARB,
                            major == 3 ? 3 : 1,
                            None};
        glXCreateContextAttribsARB(display, configs[0], nullptr, True, wish);
    }
    Drawing().frame(1);
}

void abandon() {
    Drawing().frame(0);
    ::_exit(4);
}

void become(char* self) {
    Drawing().frame(0);
    char mode[] = "abandon";
    char* const arguments[] = {self, mode, nullptr};
    ::execv(self, arguments);
}

const Drawing* last_drawing = nullptr;

void last() {
    last_drawing = new Drawing;
    last_drawing->frame(0);
    std::atexit([] { last_drawing->frame(10); });
}

// The handler is older than the recorder's.
void early_handler() {
    std::atexit([] { last_drawing->frame(10); });
    last_drawing = new Drawing;
    last_drawing->frame(0);
}

// Its child goes on without it, as a daemon does, on a connection of its own.
void leave_to_child() {
    Drawing().frame(0);
    if (::fork() != 0) ::_exit(4);
    const Drawing drawing;
    drawing.frame(1);
    drawing.frame(2);
}

void quickly() {
    const Drawing drawing;
    for (int frame = 0; frame < 3; ++frame)
        drawing.frame(frame);
    std::quick_exit(5);
}

void starved() {
    constexpr rlimit Limit{.rlim_cur = 64u << 20, .rlim_max = 64u << 20};
    ::setrlimit(RLIMIT_DATA, &Limit);
    Drawing().frame(0);
}

bool dies_attaching = false;

void attach() {
    const Drawing drawing;
    std::printf("process %d\n", static_cast<int>(::getpid()));
    std::fflush(stdout);
    dies_attaching = true;
    drawing.frame(0);
}

} // namespace

// In front of libXext's.
extern "C" __attribute__((visibility("default"))) int XShmAttach(Display* display,
                                                                 XShmSegmentInfo* segment) {
    if (dies_attaching) std::raise(SIGKILL);
    using Attach = int (*)(Display*, XShmSegmentInfo*);
    return reinterpret_cast<Attach>(::dlsym(RTLD_NEXT, "XShmAttach"))(display, segment);
}

int main(int count, char** arguments) {
    const std::string mode = count > 1 ? arguments[1] : "";
    if (mode == "noise") noise();
    if (mode == "killed") killed();
    if (mode == "endless") endless();
    if (mode == "later") later();
    if (mode == "abandon") abandon();
    if (mode == "become") become(arguments[0]);
    if (mode == "last") last();
    if (mode == "early") early_handler();
    if (mode == "daemon") leave_to_child();
    if (mode == "quick") quickly();
    if (mode == "starved") starved();
    if (mode == "attach") attach();
    if (mode == "leak" && count > 2) leak(arguments[2]);
    return EXIT_SUCCESS;
}
