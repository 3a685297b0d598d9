// RangeSet: a set of ranges of device memory, exact to the byte: what a bin reads and writes. A
// surface and vertices that share a page do not touch each other.
//
// The ranges stand apart and in order; a bin has a few surfaces and up to some hundred textures.

#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace ffgpu {

class RangeSet {
public:
    void add(std::uint64_t at, std::uint64_t bytes) {
        if (bytes == 0) return;
        Range range{at, at + bytes};
        const auto first = first_ending_from(at);
        auto last = first;
        for (; last != ranges_.end() && last->begin <= range.end; ++last)
            range.end = std::max(range.end, last->end);
        if (first == last) {
            ranges_.insert(first, range);
            return;
        }
        *first = {std::min(range.begin, first->begin), range.end};
        ranges_.erase(first + 1, last);
    }

    void remove(std::uint64_t at, std::uint64_t bytes) {
        const std::uint64_t end = at + bytes;
        std::vector<Range> left;
        for (const Range& range : ranges_) {
            if (range.begin < std::min(range.end, at))
                left.push_back({range.begin, std::min(range.end, at)});
            if (std::max(range.begin, end) < range.end)
                left.push_back({std::max(range.begin, end), range.end});
        }
        ranges_ = std::move(left);
    }

    bool overlaps(std::uint64_t at, std::uint64_t bytes) const {
        if (bytes == 0) return false;
        const auto first = std::upper_bound(
            ranges_.begin(), ranges_.end(), at, [](std::uint64_t place, const Range& range) {
                return place < range.end;
            });
        return first != ranges_.end() && first->begin < at + bytes;
    }

    bool empty() const { return ranges_.empty(); }
    void clear() { ranges_.clear(); }

private:
    struct Range {
        std::uint64_t begin, end;
    };

    // The first range that ends at `at` or later: what begins there would join it.
    std::vector<Range>::iterator first_ending_from(std::uint64_t at) {
        return std::lower_bound(
            ranges_.begin(), ranges_.end(), at, [](const Range& range, std::uint64_t place) {
                return range.end < place;
            });
    }

    std::vector<Range> ranges_;
};

} // namespace ffgpu
