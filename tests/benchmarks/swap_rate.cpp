// Preloaded into a program that draws with OpenGL: counts its swaps of buffers, prints their rate
// after a while, and ends it. The same for any library of OpenGL that the program finds.
//
//     LD_PRELOAD=libswap_rate.so FFGPU_SWAP_SECONDS=3 PROGRAM
//
// One line on standard error: "swap_rate: FRAMES frames, S s of the clock, S s of the processor".
// What comes before the second FFGPU_SWAP_SECONDS / 3 is not counted: it compiles and uploads.

#include <cstdio>
#include <cstdlib>
#include <ctime>

#include <EGL/egl.h>
#include <GL/glx.h>
#include <dlfcn.h>
#include <unistd.h>

namespace {

double seconds_on(clockid_t clock) {
    timespec now{};
    ::clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct Moment {
    double wall = seconds_on(CLOCK_MONOTONIC);
    double processor = seconds_on(CLOCK_PROCESS_CPUTIME_ID);
};

double wanted_seconds() {
    const char* const text = std::getenv("FFGPU_SWAP_SECONDS");
    return text ? std::atof(text) : 3;
}

class Counter {
public:
    void swapped() {
        const Moment now;
        if (!counting_) {
            if (now.wall - begin_.wall < seconds_ / 3) return;
            counting_ = true;
            begin_ = now;
            return;
        }
        ++frames_;
        if (now.wall - begin_.wall < seconds_) return;
        std::fprintf(stderr,
                     "swap_rate: %ld frames, %.4f s of the clock, %.4f s of the processor\n",
                     frames_,
                     now.wall - begin_.wall,
                     now.processor - begin_.processor);
        std::_Exit(0);
    }

private:
    const double seconds_ = wanted_seconds();
    Moment begin_; // of the program's first swap, then of what is counted
    bool counting_ = false;
    long frames_ = 0;
};

Counter& counter() {
    static Counter one;
    return one;
}

// The call of that name that the program would have come to.
template <class Function>
Function* behind(const char* name) {
    void* const found = dlsym(RTLD_NEXT, name);
    if (!found) {
        std::fprintf(stderr, "swap_rate: no %s behind this one\n", name);
        std::_Exit(2);
    }
    return reinterpret_cast<Function*>(found);
}

} // namespace

#define FFGPU_EXPORTED __attribute__((visibility("default")))

extern "C" FFGPU_EXPORTED void glXSwapBuffers(Display* display, GLXDrawable drawable) {
    static auto* const swap = behind<decltype(glXSwapBuffers)>("glXSwapBuffers");
    swap(display, drawable);
    counter().swapped();
}

extern "C" FFGPU_EXPORTED EGLBoolean eglSwapBuffers(EGLDisplay display, EGLSurface surface) {
    static auto* const swap = behind<decltype(eglSwapBuffers)>("eglSwapBuffers");
    const EGLBoolean swapped = swap(display, surface);
    counter().swapped();
    return swapped;
}
