// ThreadBenefit: whether sharing jobs with other threads pays. They take work off the caller, and
// may keep it waiting: where a processor is taken by somebody else, a thread that was stopped in
// the middle of a job is waited for as long as the scheduler lets others run, some milliseconds.

#pragma once

#include <algorithm>
#include <chrono>

namespace ffgpu {

class ThreadBenefit {
public:
    using Clock = std::chrono::steady_clock;
    using Duration = std::chrono::nanoseconds;

    // Of jobs that were shared: `helped` is the processor time that others spent on them, `waited`
    // that for which the caller waited for them, or wanted a processor and had none while they were
    // under way. What was gained is remembered up to MostCredit.
    void add(Duration helped, Duration waited, Clock::time_point now) {
        credit_ = std::min<Duration>(credit_ + helped - waited, MostCredit);
        if (credit_ == MostCredit) rest_per_loss_ = LeastRestPerLoss;
        if (credit_ >= -MostLoss) return;
        alone_until_ = now - rest_per_loss_ * credit_;
        rest_per_loss_ = std::min(2 * rest_per_loss_, MostRestPerLoss);
        credit_ = {};
    }

    // Whether to share what begins now: not for fifty times as long as was lost before, and each
    // time twice that, unless as much as is remembered was gained in between.
    bool pays(Clock::time_point now) const { return now >= alone_until_; }

    static constexpr Duration MostCredit = std::chrono::milliseconds(4);
    static constexpr Duration MostLoss = std::chrono::milliseconds(1);
    static constexpr int LeastRestPerLoss = 50, MostRestPerLoss = 400;

private:
    Duration credit_ = {};
    int rest_per_loss_ = LeastRestPerLoss;
    Clock::time_point alone_until_ = {};
};

} // namespace ffgpu
