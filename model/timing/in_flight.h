// InFlight: how much work is between the command processor and the last unit. Empty is what the
// command processor waits for before a clear, a copy or the end of a frame.

#pragma once

#include "model/base/check.h"
#include "model/timing/unit.h"

namespace ffgpu::timing {

class InFlight {
public:
    explicit InFlight(const Clock& clock)
        : clock_(clock) {}

    void enter(std::uint64_t n = 1) {
        count_ += n;
        changed_ = clock_.now();
    }
    void leave(std::uint64_t n = 1) {
        check(count_ >= n, "more work left than entered");
        count_ -= n;
        changed_ = clock_.now();
        if (count_ == 0 && waiter_) waiter_->wake();
    }
    // The unit that asks was_empty().
    void connect(Unit& waiter) { waiter_ = &waiter; }
    std::uint64_t count() const { return count_; }
    // Of the cycles before this one, so that the order of evaluation within a cycle is invisible.
    bool was_empty() const { return count_ == 0 && changed_ < clock_.now(); }

private:
    const Clock& clock_;
    Unit* waiter_ = nullptr;
    std::uint64_t count_ = 0;
    Cycle changed_ = 0;
};

} // namespace ffgpu::timing
