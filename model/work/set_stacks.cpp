#include "model/work/set_stacks.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <utility>

namespace ffgpu::work {

namespace {

// The values before `to` go up by one place. Most moves are short.
void push_up(std::uint32_t* values, std::uint32_t to) {
    constexpr std::uint32_t Short = 8;
    if (to > Short) {
        std::memmove(values + 1, values, to * sizeof *values);
        return;
    }
    for (std::uint32_t at = to; at > 0; --at)
        values[at] = values[at - 1];
}

} // namespace

std::uint32_t SetStacks::find(std::size_t set, std::uint32_t id) const {
    const std::uint32_t* const lines = lines_.data() + set;
    for (std::uint32_t at = 0; at < stride_; at += Block) {
        std::uint32_t found = 0;
        for (std::uint32_t i = 0; i < Block; ++i)
            found |= static_cast<std::uint32_t>(lines[at + i] == id) << i;
        if (found != 0) return at + static_cast<std::uint32_t>(std::countr_zero(found));
    }
    return NotThere;
}

// The lines above `to` go down by one; what is there is lost.
void SetStacks::push_down(std::size_t set, std::uint32_t to) {
    push_up(lines_.data() + set, to);
    if (!dirty_.empty()) push_up(dirty_.data() + set, to);
}

// Without holes and without anything dirty: each line moves down by one, to where it was.
std::uint32_t SetStacks::use_clean(const Use& use) {
    std::uint32_t* const lines = lines_.data() + set_of(use.line);
    std::uint32_t moved = use.id;
    for (std::uint32_t at = 0; at < depth_; ++at) {
        std::swap(moved, lines[at]);
        if (moved == use.id) return at;
        if (moved == Empty) return NotThere;
    }
    return NotThere;
}

std::uint32_t SetStacks::use(const Use& use, bool may_be) {
    used_ = true;
    if (dirty_.empty() && holes_ == 0 && !use.write) return use_clean(use);
    const std::size_t set = set_of(use.line);
    const std::uint32_t position = may_be ? find(set, use.id) : NotThere;
    if (use.write && dirty_.empty()) dirty_.assign(lines_.size(), WriteBacks::Clean);
    std::uint32_t dirty = use.write ? 0 : WriteBacks::Clean;
    if (position != NotThere) dirty = write_backs_.used(level(set + position), position, use.write);
    const std::uint32_t hole = holes_ > 0 ? find(set, Hole) : NotThere;
    const std::uint32_t to = std::min({position, hole, depth_ - 1});
    if (position == NotThere && hole == NotThere) {
        write_backs_.left(level(set + to));
    } else if (position == NotThere) {
        --holes_;
    } else if (hole < position) {
        lines_[set + position] = Hole;
        set_level(set + position, WriteBacks::Clean);
    }
    push_down(set, to);
    lines_[set] = use.id;
    set_level(set, dirty);
    return position;
}

void SetStacks::drop(const Use& line, bool whole) {
    const std::size_t set = set_of(line.line);
    const std::uint32_t position = find(set, line.id);
    if (position == NotThere) return;
    const std::uint32_t dirty = level(set + position);
    whole ? write_backs_.overwritten(dirty, position) : write_backs_.left(dirty);
    lines_[set + position] = Hole;
    set_level(set + position, WriteBacks::Clean);
    ++holes_;
}

void SetStacks::flush() {
    if (!used_) return;
    for (const std::uint32_t dirty : dirty_)
        write_backs_.left(dirty);
    std::fill(lines_.begin(), lines_.end(), Empty);
    std::fill(dirty_.begin(), dirty_.end(), WriteBacks::Clean);
    holes_ = 0;
    used_ = false;
}

} // namespace ffgpu::work
