#include "model/work/set_stacks.h"

#include <algorithm>

namespace ffgpu::work {

// The lines above `to` go down by one; what is there is lost.
void SetStacks::push_down(std::size_t set, std::uint32_t to) {
    std::uint32_t* const lines = lines_.data() + set;
    for (std::uint32_t at = to; at > 0; --at)
        lines[at] = lines[at - 1];
    if (!written_) return;
    std::uint32_t* const dirty = dirty_.data() + set;
    for (std::uint32_t at = to; at > 0; --at)
        dirty[at] = dirty[at - 1];
}

std::uint32_t SetStacks::use(const Use& use, bool may_be) {
    const std::size_t set = set_of(use.line);
    const std::uint32_t position = may_be ? find(set, use.id) : NotThere;
    used_ = true;
    written_ |= use.write;
    std::uint32_t level = use.write ? 0 : WriteBacks::Clean;
    if (position != NotThere && written_)
        level = write_backs_.used(dirty_[set + position], position, use.write);
    const std::uint32_t hole = holes_ > 0 ? find(set, Hole) : NotThere;
    const std::uint32_t to = std::min({position, hole, depth_ - 1});
    if (position == NotThere && hole == NotThere) {
        write_backs_.left(dirty_[set + to]);
    } else if (position == NotThere) {
        --holes_;
    } else if (hole < position) {
        lines_[set + position] = Hole;
        dirty_[set + position] = WriteBacks::Clean;
    }
    push_down(set, to);
    lines_[set] = use.id;
    dirty_[set] = level;
    return position;
}

void SetStacks::drop(const Use& line, bool whole) {
    const std::size_t set = set_of(line.line);
    const std::uint32_t position = find(set, line.id);
    if (position == NotThere) return;
    const std::uint32_t level = dirty_[set + position];
    whole ? write_backs_.overwritten(level, position) : write_backs_.left(level);
    lines_[set + position] = Hole;
    dirty_[set + position] = WriteBacks::Clean;
    ++holes_;
}

void SetStacks::flush() {
    if (!used_) return;
    for (const std::uint32_t level : dirty_)
        write_backs_.left(level);
    std::fill(lines_.begin(), lines_.end(), Empty);
    std::fill(dirty_.begin(), dirty_.end(), WriteBacks::Clean);
    holes_ = 0;
    used_ = written_ = false;
}

} // namespace ffgpu::work
