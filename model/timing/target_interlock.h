// TargetInterlock: the quads between the read of a target's pixels and the store, where no cache is
// between: so many at most, and never two of one place. Stores are done in the order of the reads.

#pragma once

#include "model/base/ring.h"
#include "model/timing/clock.h"
#include "model/timing/tokens.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

namespace ffgpu::timing {

class TargetInterlock {
public:
    explicit TargetInterlock(std::size_t entries)
        : entries_(entries) {}

    // Once a cycle: forgets the quads whose stores were done before it.
    void begin_cycle(Cycle now) {
        while (stored_ > 0 && held_.front().until <= now) {
            held_.pop_front();
            --stored_;
            ++gone_;
        }
    }
    bool admits(const PreparedQuad& quad) {
        if (held_.size() >= entries_) return false;
        for (std::size_t i = held_.size(); i-- > 0;) {
            if (held_[i].x != quad.x || held_[i].y != quad.y) continue;
            behind_ = gone_ + static_cast<std::uint32_t>(i);
            return false;
        }
        return true;
    }
    // Of the quads since the machine's start, the one of its place that it had to wait for.
    std::optional<std::uint32_t> enter(const PreparedQuad& quad) {
        held_.push_back({quad.x, quad.y, Never});
        return std::exchange(behind_, std::nullopt);
    }
    // The store of the oldest quad that has not stored yet will have been taken.
    void store(Cycle until) { held_[stored_++].until = until; }

    // A store is under way: a quad that is not admitted may be soon.
    bool changes() const { return stored_ > 0; }

private:
    struct Held {
        std::uint16_t x = 0, y = 0;
        Cycle until = Never;
    };

    std::size_t entries_;
    Ring<Held> held_;
    std::size_t stored_ = 0; // of them, the oldest
    std::uint32_t gone_ = 0; // before them
    std::optional<std::uint32_t> behind_{};
};

} // namespace ffgpu::timing
