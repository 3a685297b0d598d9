// OptimalTags: which look-ups of a read-only cache hit under optimal replacement (L. A. Belady, IBM
// Systems Journal 5 (2), 1966), told one after the other, without the look-ups to come.
//
// Between two look-ups of a line the line is kept or given up. Each set has a place for the line
// that is looked up and ways - 1 places for lines that are kept meanwhile. No policy keeps more
// lines than the greedy schedule of these intervals by their ends: an interval is kept where a
// place has been free since it began, best the one that became free last (M. C. Carlisle, E. L.
// Lloyd, On the k-Coloring of Intervals, 1995). So what has been looked up by now decides whether
// this look-up hits (as A. Jain and C. Lin found, Back to the Future: Leveraging Belady's Algorithm
// for Improved Cache Replacement, ISCA 2016). Where the lines are in between, it does not tell:
// lines that are written have to be known, and such caches cannot have it.

#pragma once

#include "model/work/cache_policy.h"

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace ffgpu::work {

class OptimalTags {
public:
    OptimalTags(std::uint32_t sets, std::uint32_t ways, IndexHash hash);

    // The next look-up is of `line`: null where it misses, else the fill that brought the line.
    // Does not count as a look-up.
    const std::uint64_t* find(std::uint64_t line) const;

    // The look-up: of a line that find() finds, or of another, which is brought by `fill`.
    void use(std::uint64_t line);
    void replace(std::uint64_t line, std::uint64_t fill);

    // Forgets a line: its next look-up misses.
    void drop(std::uint64_t line) { lines_.erase(line); }
    void clear();

private:
    struct Line {
        std::uint64_t last_use = 0; // look-ups of its set are counted
        std::uint64_t fill = 0;
    };
    struct Set {
        std::uint64_t lookups = 0;
        // For each place of a kept line, the look-up at the end of the last interval that it held.
        std::vector<std::uint64_t> kept_until;
    };

    // The place that can have held the line since `last_use`; `ways - 1` where there is none.
    std::size_t place_since(const Set& set, std::uint64_t last_use) const;
    void count(std::uint64_t line, Line& entry);

    SetIndex set_of_;
    std::vector<Set> sets_;
    std::unordered_map<std::uint64_t, Line> lines_; // all that were looked up
};

} // namespace ffgpu::work
