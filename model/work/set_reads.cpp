#include "model/work/set_reads.h"

#include "model/base/check.h"

#include <algorithm>

namespace ffgpu::work {

SetReads::SetReads(std::uint32_t most_sets, std::uint32_t most_ways, AgeStacks::Time most_times)
    : most_ways_(most_ways)
    , most_times_(most_times)
    , stacks_(most_sets, most_ways) {
    check(stacks_.levels() <= RecentLines::MostLevels, "at most 65536 sets");
}

std::span<const std::uint32_t> SetReads::use(const SetRead& read) {
    std::span<const std::uint32_t> found;
    if (read.left > 0) found = positions(read);
    switch (read.kind) {
    case SetRead::Kind::Use:
        if (read.now == 0) break;
        last_ = read.now;
        if (short_of(last_) >= most_times_) count_anew();
        stacks_.use(read.leaving, short_of(read.before), short_of(read.now));
        break;
    case SetRead::Kind::Drop:
        stacks_.drop(read.leaving, short_of(read.before));
        break;
    case SetRead::Kind::Flush:
        stacks_.flush();
    }
    return found;
}

// Below the top a line lies under those that left it later, and so do of the newest lines those
// that still stand there, above it: they are counted once. The others came from below it, and took
// the holes above it first.
std::span<const std::uint32_t> SetReads::positions(const SetRead& read) {
    const NewerSharers::Counts newer = read.newer.counts();
    std::size_t level = stacks_.positions(read.line, short_of(read.left), positions_);
    if (stacks_.has_holes())
        for (std::size_t i = 0; i < level; ++i)
            positions_[i] -=
                std::min<std::uint32_t>(newer[i], stacks_.holes_above(i, read.line, positions_[i]));
    for (std::size_t i = level; i < positions_.size(); ++i)
        positions_[i] = 0;
    for (std::size_t i = 0; i < positions_.size(); ++i)
        positions_[i] = std::min(positions_[i] + newer[i], most_ways_);
    while (level < stacks_.levels() && positions_[level] > 0)
        ++level;
    while (level > 0 && positions_[level - 1] == 0) // Of more sets it is at no higher a position.
        --level;
    return std::span(positions_).first(level);
}

AgeStacks::Time SetReads::short_of(SetRead::Time time) const {
    if (time > counted_)
        return static_cast<AgeStacks::Time>(time - counted_ + 2 * old_times_.size() + 1);
    if (time == 0) return 0;
    const auto at = std::lower_bound(old_times_.begin(), old_times_.end(), time);
    const auto earlier = static_cast<AgeStacks::Time>(at - old_times_.begin());
    const bool stands_there = at != old_times_.end() && *at == time;
    return 2 * earlier + (stands_there ? 2 : 1);
}

SetRead::Time SetReads::long_of(AgeStacks::Time time) const {
    const std::size_t old = 2 * old_times_.size() + 1;
    return time > old ? counted_ + (time - old) : old_times_[time / 2 - 1];
}

// What stands in the stacks becomes the old times; last_ is not among it.
void SetReads::count_anew() {
    std::vector<SetRead::Time> times;
    stacks_.for_each_time([&](AgeStacks::Time time) {
        if (time > 0) times.push_back(long_of(time)); // A hole may have none.
    });
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end()), times.end());
    stacks_.count_anew([&](AgeStacks::Time time) {
        if (time == 0) return time;
        const auto at = std::lower_bound(times.begin(), times.end(), long_of(time));
        return static_cast<AgeStacks::Time>(at - times.begin() + 1) * 2;
    });
    old_times_ = std::move(times);
    counted_ = last_ - 1;
    check(short_of(last_) < most_times_, "times for all lines and holes");
}

} // namespace ffgpu::work
