// LineStack: the LRU stack of all lines that were looked up, however deep: what fully associative
// caches of any size do. Holes are as in set_stacks.h.

#pragma once

#include "model/work/position_tree.h"
#include "model/work/write_backs.h"

#include <cstdint>
#include <queue>
#include <vector>

namespace ffgpu::work {

class LineStack {
public:
    static constexpr std::uint32_t NotThere = ~std::uint32_t{0};

    // Lines are numbered (line_numbers.h). Returns the position at which it was.
    std::uint32_t use(std::uint32_t id, bool write);
    // The same in two steps, of a line that is clean: between them it lies on top of them all, and
    // is not counted.
    std::uint32_t take(std::uint32_t id);
    void put(std::uint32_t id);

    // The line was used, and not thrown out since.
    bool has(std::uint32_t id) const { return id < lines_.size() && lines_[id].time != NotThere; }
    // A write would change nothing, at no position of the line.
    bool is_dirty_everywhere(std::uint32_t id) const { return lines_[id].level == 0; }

    void drop(std::uint32_t id, bool whole);
    void flush();

    const WriteBacks& write_backs() const { return write_backs_; }

private:
    static constexpr std::uint32_t Hole = ~std::uint32_t{0};

    struct Line {
        std::uint32_t time = NotThere;
        std::uint32_t level = WriteBacks::Clean;
    };

    Line& line(std::uint32_t id) {
        if (id >= lines_.size()) lines_.resize(std::size_t{id} * 2 + 64);
        return lines_[id];
    }
    void make_room();
    void take_off(std::uint32_t time);
    void put_on(std::uint32_t id);

    PositionTree tree_;
    std::vector<std::uint32_t> owners_; // of the bits, by time: a line or Hole
    std::priority_queue<std::uint32_t> holes_;
    std::vector<Line> lines_;
    WriteBacks write_backs_;
};

} // namespace ffgpu::work
