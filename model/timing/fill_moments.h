// FillMoments: when the fills of a cache had come, in the order of their numbers: of each, when it
// and all before it were there.

#pragma once

#include "model/base/ring.h"
#include "model/timing/memory_waits.h"
#include "model/timing/moments.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <utility>
#include <vector>

namespace ffgpu::timing {

class FillMoments {
public:
    // `most`: fills that may be under way at once.
    explicit FillMoments(std::size_t most)
        : kept_(std::bit_ceil(2 * most))
        , moments_(kept_)
        , came_(kept_) {}

    // The memory, not another cache, answers to them in any order.
    void number_next(std::uint64_t ticket) { numbers_.push_back(ticket); }
    // The next answer is there. Fills are numbered from 1.
    void come(WaitPaths& paths, const Moment& answer) {
        std::uint64_t ticket = answers_++ + 1;
        if (!numbers_.empty()) {
            ticket = numbers_.front();
            numbers_.pop_front();
        }
        if (ticket == 0) return; // Nobody waits for it.
        while (ticket >= next_ + kept_ / 2)
            grow();
        moments_[ticket] = answer;
        came_[ticket % kept_] = 1;
        for (; came_[next_ % kept_] != 0; ++next_) {
            came_[next_ % kept_] = 0;
            merge(paths, all_, moments_[next_]);
            moments_[next_] = all_;
        }
    }
    // Null: it has not come, or so long ago that nobody can wait for it.
    const Moment* find(std::uint64_t ticket) const {
        return ticket < next_ && ticket + kept_ / 2 >= next_ ? &moments_[ticket] : nullptr;
    }

    void restart() {
        std::fill(moments_.begin(), moments_.end(), Moment{});
        all_ = {};
    }
    template <class Add>
    void for_each_path(const Add& add) {
        for (Moment& moment : moments_)
            add(moment.path);
        add(all_.path);
    }

private:
    void grow() {
        FillMoments more(kept_);
        for (std::uint64_t i = std::max(next_, kept_ / 2) - kept_ / 2; i < next_ + kept_ / 2; ++i) {
            more.moments_[i] = moments_[i];
            more.came_[i % more.kept_] = came_[i % kept_];
        }
        kept_ = more.kept_;
        moments_ = std::move(more.moments_);
        came_ = std::move(more.came_);
    }

    std::uint64_t kept_;
    Moments moments_;
    std::vector<std::uint8_t> came_; // behind one that has not
    std::uint64_t next_ = 1, answers_ = 0;
    Ring<std::uint64_t> numbers_;
    Moment all_;
};

} // namespace ffgpu::timing
