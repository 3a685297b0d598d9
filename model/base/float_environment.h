// FloatEnvironment: while it lives, the thread computes as the specification says: rounding to
// nearest even, subnormals kept, no traps. Programs built with -ffast-math, or that call
// fesetround, set their threads otherwise; they find their own mode again afterwards.
//
// Setting the mode costs tens of cycles, looking at it one or two nanoseconds: it is set only where
// it differs.

#pragma once

#include <cstdint>

#if defined(__x86_64__)
#include <xmmintrin.h>
#elif !defined(__aarch64__)
#include <cfenv>
#endif

namespace ffgpu {

class FloatEnvironment {
public:
    FloatEnvironment()
        : callers_(read())
        , differs_(!is_default(callers_)) {
        if (differs_) [[unlikely]]
            set_default();
    }
    ~FloatEnvironment() {
        if (differs_) [[unlikely]]
            write(callers_);
    }
    FloatEnvironment(const FloatEnvironment&) = delete;
    FloatEnvironment& operator=(const FloatEnvironment&) = delete;

private:
#if defined(__x86_64__)
    using Control = std::uint32_t; // MXCSR
    static constexpr Control Default = 0x1f80;
    static constexpr Control Flags = 0x3f; // exceptions that came up: no mode
    static Control read() {
        return _mm_getcsr();
    }
    static bool is_default(Control control) {
        return (control & ~Flags) == Default;
    }
    static void set_default() {
        write(Default);
    }
    // The compiler knows nothing of the mode: it must not move computations over the change.
    static void write(Control control) {
        asm volatile("" ::: "memory");
        _mm_setcsr(control);
        asm volatile("" ::: "memory");
    }
#elif defined(__aarch64__)
    using Control = std::uint64_t; // FPCR
    static Control read() {
        Control control;
        asm volatile("mrs %0, fpcr" : "=r"(control));
        return control;
    }
    static bool is_default(Control control) {
        return control == 0;
    }
    static void set_default() {
        write(0);
    }
    static void write(Control control) {
        asm volatile("msr fpcr, %0" ::"r"(control) : "memory");
    }
#else
    // The standard library does not tell whether subnormals are kept: the mode is set each time.
    using Control = std::fenv_t;
    static Control read() {
        std::fenv_t environment;
        std::fegetenv(&environment);
        return environment;
    }
    static bool is_default(const Control&) {
        return false;
    }
    static void set_default() {
        std::fesetenv(FE_DFL_ENV);
    }
    static void write(const Control& control) {
        std::fesetenv(&control);
    }
#endif

    Control callers_;
    bool differs_;
};

} // namespace ffgpu
