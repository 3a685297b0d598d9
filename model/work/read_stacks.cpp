#include "model/work/read_stacks.h"

#include "model/base/check.h"

#include <algorithm>
#include <bit>

namespace ffgpu::work {

ReadStacks::ReadStacks(std::uint32_t most_sets, std::uint32_t most_ways, AgeStacks::Time most_times)
    : most_ways_(most_ways)
    , most_times_(most_times)
    , stacks_(most_sets, most_ways)
    , recent_(stacks_.levels()) {
    check(stacks_.levels() <= RecentLines::MostLevels, "at most 65536 sets");
}

ReadStacks::Line& ReadStacks::record(std::uint32_t id) {
    if (id >= lines_.size()) lines_.resize(std::size_t{id} * 2 + 64);
    return lines_[id];
}

ReadStacks::Found ReadStacks::look_up(std::uint64_t line, std::uint64_t number) {
    const Near near = look_up_near(line, number);
    if (!near) return look_up_older(line, number);
    std::size_t levels = 0;
    for (Sharers rest = near.positions; rest != 0; rest >>= 4)
        positions_[levels++] = std::min(static_cast<std::uint32_t>(rest & 15), most_ways_);
    return {near.last, true, near.depth, std::span(positions_).first(levels)};
}

ReadStacks::Found ReadStacks::look_up_older(std::uint64_t line, std::uint64_t number) {
    Found found;
    const std::uint32_t id = numbers_[line];
    Line& known = record(id);
    known.line = line;
    found.last = known.last;
    known.last = number;
    found.known = all_.has(id);
    if (found.known) {
        stacks_.prefetch(line);
        find_older(id, found);
    } else {
        known.left = 0; // It may stand there from before a flush.
        all_.take(id);
    }
    if (leaves_now_) leave(recent_.newest());
    recent_.newest() = {line, number, id, lines_[id].left};
    return found;
}

// Of the newest lines those that left the top last before the line did.
void ReadStacks::count_newer_sharers(const Line& line) {
    const std::size_t levels = stacks_.levels();
    std::array<std::uint32_t, RecentLines::MostLevels + 1> sharing{}; // so many lowest bits
    for (const RecentLines::Use& use : recent_.uses()) {
        const auto bits = static_cast<std::size_t>(std::countr_zero(use.line ^ line.line));
        sharing[std::min(bits, levels)] += use.left <= line.left;
    }
    std::uint32_t sharers = 0;
    for (std::size_t level = levels; level-- > 0;)
        sharers_[level] = sharers += sharing[level + 1];
}

// Below the top a line lies under those that left it later, and so do of the newest lines those
// that still stand there, above it: they are counted once. The others came from below it, and took
// the holes above it first.
void ReadStacks::find_older(std::uint32_t id, Found& found) {
    const Line& line = lines_[id];
    count_newer_sharers(line);
    const unsigned newer_lines = leaves_now_ ? RecentLines::Most : recent_.size() - 1;
    found.depth = newer_lines + all_.take(id);
    const std::size_t below = stacks_.positions(line.line, line.left, positions_);
    std::size_t level = 0;
    for (; level < stacks_.levels(); ++level) {
        std::uint32_t& position = positions_[level];
        if (level >= below) position = 0;
        const std::uint32_t newer = sharers_[level];
        if (stacks_.has_holes())
            position -= std::min(newer, stacks_.holes_above(level, line.line, position));
        position = std::min(position + newer, most_ways_);
        if (position == 0) break;
    }
    found.positions = std::span(positions_).first(level);
}

// To the stacks below, where it moves to the front.
void ReadStacks::leave(const RecentLines::Use& use) {
    if (leaves_ == most_times_) count_anew();
    const AgeStacks::Time before = use.left;
    Line& line = lines_[use.id];
    line.last = use.place;
    line.left = ++leaves_;
    all_.put(use.id);
    stacks_.use(line.line, before, line.left);
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
    recent_.all_leave([this](const RecentLines::Use& use) { leave(use); });
}

// All times that are told become 1, 2, 3 ...
void ReadStacks::count_anew() {
    std::vector<AgeStacks::Time> times;
    const auto tell = [&](AgeStacks::Time time) { times.push_back(time); };
    stacks_.for_each_time(tell);
    for (const Line& line : lines_)
        if (line.left > 0) tell(line.left);
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end()), times.end());
    const auto now_of = [&](AgeStacks::Time time) {
        const auto at = std::lower_bound(times.begin(), times.end(), time);
        return static_cast<AgeStacks::Time>(at - times.begin()) + 1;
    };
    stacks_.count_anew(now_of);
    for (Line& line : lines_)
        if (line.left > 0) line.left = now_of(line.left);
    for (RecentLines::Use& use : recent_.uses())
        if (use.left > 0 && use.left != RecentLines::Unused) use.left = now_of(use.left);
    leaves_ = static_cast<AgeStacks::Time>(times.size());
    check(leaves_ < most_times_, "times for all lines and holes");
}

bool ReadStacks::has(std::uint64_t line) {
    return recent_.has(line) || all_.has(numbers_[line]);
}

// The newest lines first go to the stacks below, where they would be above the hole.
void ReadStacks::drop(std::uint64_t line) {
    if (!has(line)) return;
    all_leave();
    const std::uint32_t id = numbers_[line];
    all_.drop(id, true);
    stacks_.drop(line, lines_[id].left);
}

void ReadStacks::flush() {
    recent_.all_leave([this](const RecentLines::Use& use) { lines_[use.id].last = use.place; });
    all_.flush();
    stacks_.flush();
}

std::vector<std::uint64_t> ReadStacks::oldest_first() {
    all_leave();
    std::vector<std::uint64_t> lines;
    for (const std::uint32_t id : older_first())
        lines.push_back(lines_[id].line);
    return lines;
}

} // namespace ffgpu::work
