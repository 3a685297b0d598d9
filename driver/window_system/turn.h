// Turn: held during each call of OpenGL or of the window system, so that the contexts of several
// threads take turns on the device (GLX 1.4, 2.5: a context is current in one thread, but several
// contexts may be current at once).
//
// Nearly every program calls OpenGL from one thread, up to tens of millions of times a second. So
// the lock is biased: the first thread that takes a turn owns it, and its calls cost two plain
// stores. When a second thread comes, it takes the bias away: it says so, has the kernel run a
// memory barrier on all of the process's processors (membarrier(2)), and waits until the owner is
// out of its call. From then on all threads use the mutex.

#pragma once

#include "model/base/float_environment.h"

#include <atomic>

namespace ffgpu::gl {

namespace detail {

struct TurnState {
    std::atomic<bool> shared = false; // The bias is taken away, for ever.
    std::atomic<unsigned> inside = 0; // how deep the owner is in its calls
};
extern TurnState turn_state __attribute__((visibility("hidden")));
// This thread owns the bias.
extern constinit thread_local bool owns_turn
    __attribute__((visibility("hidden"), tls_model("initial-exec")));

bool lock_turn(); // True: by becoming the owner.
void unlock_turn();

} // namespace detail

// The caller's floating-point mode stays: for calls that only move numbers. To look at the mode
// takes as long as all the rest of a glVertex.
struct CallersMode {};

// Environment: what the turn's holder computes in; the caller's mode comes back with the turn's
// end.
template <class Environment>
class TurnIn {
public:
    // In each of the exported functions: a call more would be a tenth of glVertex.
    [[gnu::always_inline]] TurnIn() {
        if (detail::owns_turn) [[likely]] {
            depth_ = detail::turn_state.inside.load(std::memory_order_relaxed);
            detail::turn_state.inside.store(depth_ + 1, std::memory_order_relaxed);
            // The compiler keeps store and load in order; membarrier in the other thread makes
            // the processor do so where it matters.
            std::atomic_signal_fence(std::memory_order_seq_cst);
            if (depth_ > 0 || !detail::turn_state.shared.load(std::memory_order_acquire)) [[likely]]
                return;
            detail::turn_state.inside.store(0, std::memory_order_release);
        }
        depth_ = detail::lock_turn() ? 0 : InMutex;
    }
    ~TurnIn() {
        if (depth_ != InMutex) [[likely]]
            detail::turn_state.inside.store(depth_, std::memory_order_release);
        else
            detail::unlock_turn();
    }
    TurnIn(const TurnIn&) = delete;
    TurnIn& operator=(const TurnIn&) = delete;

private:
    [[no_unique_address]] const Environment environment_{};
    unsigned depth_ = 0; // of the owner's calls around this one
    static constexpr unsigned InMutex = ~0u;
};

using Turn = TurnIn<FloatEnvironment>;

} // namespace ffgpu::gl
