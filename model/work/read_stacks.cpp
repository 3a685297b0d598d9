#include "model/work/read_stacks.h"

#include <algorithm>
#include <bit>

namespace ffgpu::work {

ReadStacks::ReadStacks(std::size_t levels)
    : recent_(levels) {
    for (std::size_t bits = 1; bits < shared_.size(); ++bits) {
        shared_[bits] = shared_[bits - 1];
        const std::size_t level = bits - 1;
        if (level < levels)
            shared_[bits].words[level / NewerSharers::Bytes] |=
                std::uint64_t{1} << (8 * (level % NewerSharers::Bytes));
    }
}

ReadStacks::Line& ReadStacks::record(std::uint32_t id) {
    if (id >= lines_.size()) lines_.resize(std::size_t{id} * 2 + 64);
    return lines_[id];
}

ReadStacks::Found
ReadStacks::look_up_older(std::uint64_t line, std::uint64_t number, SetRead& read) {
    const std::uint32_t id = numbers_[line];
    Line& known = record(id);
    known.line = line;
    Found found{.last = std::exchange(known.last, number), .known = all_.has(id)};
    const std::uint32_t below = all_.take(id);
    if (found.known) {
        const unsigned newer_lines = leaves_now_ ? RecentLines::Most : recent_.size() - 1;
        found.depth = newer_lines + below;
        read.line = line;
        read.left = known.left;
        read.newer = newer_sharers(known);
        read.depth = found.depth;
    } else {
        known.left = 0; // It may stand there from before a flush.
    }
    if (leaves_now_) leave(recent_.newest(), read);
    recent_.newest() = {.line = line, .place = number, .left = lines_[id].left, .id = id};
    return found;
}

// Of the newest lines those that left the top last before the line did.
NewerSharers ReadStacks::newer_sharers(const Line& line) const {
    NewerSharers sum;
    for (const RecentLines::Use& use : recent_.uses()) {
        const NewerSharers& shared =
            shared_[static_cast<std::size_t>(std::countr_zero(use.line ^ line.line))];
        const std::uint64_t counts = use.left <= line.left ? ~std::uint64_t{0} : 0;
        sum.words[0] += shared.words[0] & counts;
        sum.words[1] += shared.words[1] & counts;
    }
    return sum;
}

// To the stacks below, where it moves to the front.
void ReadStacks::leave(const RecentLines::Use& use, SetRead& read) {
    Line& line = lines_[use.id];
    line.last = use.place;
    line.left = ++leaves_;
    all_.put(use.id);
    read.leaving = line.line;
    read.before = use.left;
    read.now = line.left;
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

void ReadStacks::all_leave(std::vector<SetRead>& reads) {
    recent_.all_leave([&](const RecentLines::Use& use) { leave(use, reads.emplace_back()); });
}

bool ReadStacks::has(std::uint64_t line) {
    return recent_.has(line) || all_.has(numbers_[line]);
}

// The newest lines first go to the stacks below, where they would be above the hole.
void ReadStacks::drop(std::uint64_t line, std::vector<SetRead>& reads) {
    if (!has(line)) return;
    all_leave(reads);
    const std::uint32_t id = numbers_[line];
    all_.drop(id, true);
    SetRead& read = reads.emplace_back();
    read.kind = SetRead::Kind::Drop;
    read.leaving = line;
    read.before = lines_[id].left;
}

void ReadStacks::flush(std::vector<SetRead>& reads) {
    recent_.all_leave([this](const RecentLines::Use& use) { lines_[use.id].last = use.place; });
    all_.flush();
    reads.emplace_back().kind = SetRead::Kind::Flush;
}

std::vector<std::uint64_t> ReadStacks::oldest_first(std::vector<SetRead>& reads) {
    all_leave(reads);
    std::vector<std::uint64_t> lines;
    for (const std::uint32_t id : older_first())
        lines.push_back(lines_[id].line);
    return lines;
}

} // namespace ffgpu::work
