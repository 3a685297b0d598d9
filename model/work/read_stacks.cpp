#include "model/work/read_stacks.h"

#include "model/base/check.h"

#include <algorithm>

namespace ffgpu::work {
ReadStacks::ReadStacks(std::uint32_t most_sets, std::uint32_t most_ways, AgeStacks::Time most_times)
    : most_ways_(most_ways)
    , most_times_(most_times) {
    for (std::uint32_t sets = 2; sets <= most_sets; sets *= 2)
        stacks_.emplace_back(sets, most_ways);
}

ReadStacks::Line& ReadStacks::record(std::uint32_t id) {
    if (id >= lines_.size()) lines_.resize(std::size_t{id} * 2 + 64);
    return lines_[id];
}

ReadStacks::Found ReadStacks::look_up(std::uint64_t line, std::uint64_t number) {
    const RecentUse use = recent_.use(line, std::span(positions_).first(stacks_.size()));
    if (use.slot < RecentLines::Most) {
        for (std::size_t level = 0; level < use.levels && positions_[level] > most_ways_; ++level)
            positions_[level] = most_ways_;
        return {.last = std::exchange(recent_.place(use.slot), number),
                .known = true,
                .depth = use.newer,
                .positions = std::span(positions_).first(use.levels)};
    }
    Found found;
    const std::uint32_t id = numbers_[line];
    Line& known = record(id);
    known.line = line;
    found.last = known.last;
    known.last = number;
    found.known = all_.has(id);
    if (found.known) {
        find_older(id, found);
    } else {
        known.left = 0; // It may stand there from before a flush.
        all_.take(id);
    }
    if (recent_.full()) oldest_leaves();
    recent_.add(line, {number, known.left, id});
    return found;
}

void ReadStacks::prefetch(std::uint64_t line) const {
    for (const AgeStacks& stack : stacks_)
        stack.prefetch(line);
}

// Below the top a line lies under those that left it later, and so do of the newest lines those
// that still stand there, above it: they are counted once. The others came from below it, and took
// the holes above it first.
void ReadStacks::find_older(std::uint32_t id, Found& found) {
    const Line& line = lines_[id];
    prefetch(line.line);
    const std::size_t shared = sharers(recent_.slots(),
                                       left_by(recent_.slots(), line.left),
                                       line.line,
                                       std::span(sharers_).first(stacks_.size()));
    found.depth = recent_.size() + all_.take(id);
    std::uint32_t below = most_ways_; // never deeper than in half as many sets
    std::size_t level = 0;
    for (; level < stacks_.size(); ++level) {
        const AgeStacks& stack = stacks_[level];
        if (below > 0) below = stack.position(line.line, line.left);
        const std::uint32_t newer = level < shared ? sharers_[level] : 0;
        const std::uint32_t taken = std::min(newer, stack.holes_above(line.line, below));
        positions_[level] = std::min(below + newer - taken, most_ways_);
        if (positions_[level] == 0) break;
    }
    found.positions = std::span(positions_).first(level);
}

// To the stacks below, where it moves to the front.
void ReadStacks::oldest_leaves() {
    if (leaves_ == most_times_) count_anew();
    const unsigned oldest = recent_.oldest();
    const RecentLines::Use use = recent_.use_of(oldest);
    Line& line = lines_[use.id];
    line.last = use.place;
    line.left = ++leaves_;
    all_.put(use.id);
    for (AgeStacks& stack : stacks_)
        if (stack.use(line.line, use.left, line.left) == 0 && use.left > 0) break;
    recent_.drop(oldest);
    if (recent_.size() > 0) prefetch(recent_.line(recent_.oldest())); // the next that leaves
}

std::vector<std::uint32_t> ReadStacks::older_first() const {
    std::vector<std::uint32_t> ids;
    for (std::uint32_t id = 0; id < lines_.size(); ++id)
        if (all_.has(id)) ids.push_back(id);
    std::sort(ids.begin(), ids.end(), [this](std::uint32_t a, std::uint32_t b) {
        return lines_[a].left < lines_[b].left;
    });
    return ids;
}

void ReadStacks::all_leave() {
    while (recent_.size() > 0)
        oldest_leaves();
}

// All times that are told become 1, 2, 3 ...
void ReadStacks::count_anew() {
    std::vector<AgeStacks::Time> times;
    const auto tell = [&](AgeStacks::Time time) { times.push_back(time); };
    for (const AgeStacks& stack : stacks_)
        stack.for_each_time(tell);
    for (const Line& line : lines_)
        if (line.left > 0) tell(line.left);
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end()), times.end());
    const auto now_of = [&](AgeStacks::Time time) {
        const auto at = std::lower_bound(times.begin(), times.end(), time);
        return static_cast<AgeStacks::Time>(at - times.begin()) + 1;
    };
    for (AgeStacks& stack : stacks_)
        stack.count_anew(now_of);
    for (Line& line : lines_)
        if (line.left > 0) line.left = now_of(line.left);
    for (unsigned slot = 0; slot < RecentLines::Most; ++slot) {
        const AgeStacks::Time left = recent_.use_of(slot).left;
        if (recent_.has(slot) && left > 0) recent_.set_left(slot, now_of(left));
    }
    leaves_ = static_cast<AgeStacks::Time>(times.size());
    check(leaves_ < most_times_, "times for all lines and holes");
}

bool ReadStacks::has(std::uint64_t line) {
    return recent_.slot_of(line) < RecentLines::Most || all_.has(numbers_[line]);
}

// The newest lines first go to the stacks below, where they would be above the hole.
void ReadStacks::drop(std::uint64_t line) {
    if (!has(line)) return;
    all_leave();
    const std::uint32_t id = numbers_[line];
    all_.drop(id, true);
    for (AgeStacks& stack : stacks_)
        stack.drop(line, lines_[id].left);
}

void ReadStacks::flush() {
    for (unsigned slot = 0; slot < RecentLines::Most; ++slot)
        if (recent_.has(slot)) lines_[recent_.use_of(slot).id].last = recent_.place(slot);
    recent_.clear();
    all_.flush();
    for (AgeStacks& stack : stacks_)
        stack.flush();
}

std::vector<std::uint64_t> ReadStacks::oldest_first() {
    all_leave();
    std::vector<std::uint64_t> lines;
    for (const std::uint32_t id : older_first())
        lines.push_back(lines_[id].line);
    return lines;
}

} // namespace ffgpu::work
