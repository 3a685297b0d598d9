// The fewest misses of a sequence of look-ups, by brute force.

#pragma once

#include <algorithm>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

namespace ffgpu::work {

using Trace = std::vector<std::uint64_t>;

// The fewest misses that any choice of victims can reach, fully associative, by trying them all.
inline std::uint64_t
fewest(const Trace& trace, std::size_t at, std::set<std::uint64_t> held, unsigned n) {
    while (at < trace.size() && held.count(trace[at]) > 0)
        ++at;
    if (at == trace.size()) return 0;
    if (held.size() < n) {
        held.insert(trace[at]);
        return 1 + fewest(trace, at + 1, std::move(held), n);
    }
    std::uint64_t best = ~std::uint64_t{0};
    for (const std::uint64_t victim : held) {
        std::set<std::uint64_t> next = held;
        next.erase(victim);
        next.insert(trace[at]);
        best = std::min(best, fewest(trace, at + 1, std::move(next), n));
    }
    return 1 + best;
}

} // namespace ffgpu::work
