// TagArray: a set-associative cache's tags with least-recently-used replacement. A pure data
// structure: no time, no memory.

#pragma once

#include <cstdint>
#include <vector>

namespace ffgpu::work {

class TagArray {
public:
    struct Line {
        static constexpr std::uint64_t Empty = ~std::uint64_t{0};
        std::uint64_t number = Empty; // address / line bytes
        std::uint64_t last_use = 0;
        std::uint64_t fill = 0; // ticket of the fill that brings or brought it
        bool dirty = false;
    };

    // `sets` a power of two; sets = 1 is fully associative.
    TagArray(std::uint32_t sets, std::uint32_t ways)
        : set_mask_(sets - 1)
        , ways_(ways)
        , lines_(std::size_t{sets} * ways) {}

    // The line where it is present, which makes it the most recently used; else null.
    Line* find(std::uint64_t number) {
        Line* const set = set_of(number);
        for (std::uint32_t way = 0; way < ways_; ++way) {
            if (set[way].number != number) continue;
            set[way].last_use = ++uses_;
            return &set[way];
        }
        return nullptr;
    }

    // The place that `number` will take: an empty one, else the least recently used of its set.
    Line& victim(std::uint64_t number) {
        Line* const set = set_of(number);
        Line* oldest = set;
        for (std::uint32_t way = 1; way < ways_; ++way) {
            if (set[way].last_use < oldest->last_use) oldest = &set[way];
        }
        return *oldest;
    }

    // Puts `number` in its victim's place, as the most recently used.
    Line& replace(std::uint64_t number) {
        Line& line = victim(number);
        line = {.number = number, .last_use = ++uses_};
        return line;
    }

    std::vector<Line>& lines() { return lines_; }

private:
    Line* set_of(std::uint64_t number) { return &lines_[(number & set_mask_) * ways_]; }

    std::uint64_t set_mask_;
    std::uint32_t ways_;
    std::uint64_t uses_ = 0;
    std::vector<Line> lines_;
};

} // namespace ffgpu::work
