// Account: what a unit did with each cycle. busy + idle + stalled = all cycles, always.

#pragma once

#include "model/base/statistics.h"
#include "model/timing/clock.h"

#include <array>
#include <string>
#include <string_view>

namespace ffgpu::timing {

enum class Activity : std::uint8_t {
    Busy,
    Idle,            // nothing at the input
    StalledOutput,   // the next unit takes nothing
    StalledMemory,   // data of a miss have not come
    StalledRequests, // the memory takes no request, or too many are outstanding
    Count
};

inline constexpr std::array<std::string_view, static_cast<std::size_t>(Activity::Count)>
    ActivityNames{"busy", "idle", "stalled_output", "stalled_memory", "stalled_requests"};

class Account : public StatisticsGroup {
public:
    explicit Account(std::string_view unit)
        : unit_(unit) {
        static constexpr std::array<std::string_view, static_cast<std::size_t>(Activity::Count)>
            Meanings{"cycles in which the unit moved something",
                     "cycles without input",
                     "cycles in which the next unit took nothing",
                     "cycles waiting for the data of a miss",
                     "cycles in which the memory took no request"};
        for (std::size_t i = 0; i < cycles_.size(); ++i) {
            names_[i] = unit_ + '_' + std::string(ActivityNames[i]) + "_cycles";
            cycles_[i] = &count(names_[i], "cycles", Meanings[i]);
        }
    }

    void add(Activity activity, Cycle cycles) {
        *cycles_[static_cast<std::size_t>(activity)] += cycles;
    }
    Cycle cycles(Activity activity) const {
        return cycles_[static_cast<std::size_t>(activity)]->value();
    }
    Cycle total() const {
        Cycle sum = 0;
        for (const Counter* counter : cycles_)
            sum += counter->value();
        return sum;
    }
    const std::string& unit() const { return unit_; }

private:
    std::string unit_;
    std::array<std::string, static_cast<std::size_t>(Activity::Count)>
        names_; // Counter keeps views.
    std::array<Counter*, static_cast<std::size_t>(Activity::Count)> cycles_{};
};

} // namespace ffgpu::timing
