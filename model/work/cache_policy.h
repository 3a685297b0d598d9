// What a cache is free to choose besides its size: which line gives way, and which set a line
// belongs to.

#pragma once

#include "model/base/parameters.h"

#include <array>
#include <cstdint>
#include <string_view>

namespace ffgpu::work {

// Which line of a full set gives way. Optimal is a bound of the others: no hardware has it. Caches
// that are only read can have it in the machine (optimal_tags.h), or where a trace is replayed
// (line_replay.h).
enum class Replacement : std::uint8_t { Lru, Fifo, Random, Optimal };
inline constexpr std::array<std::string_view, 4> ReplacementNames{
    "lru", "fifo", "random", "optimal"};

enum class IndexHash : std::uint8_t { Modulo, Xor };
inline constexpr std::array<std::string_view, 2> IndexHashNames{"modulo", "xor"};

struct CachePolicy {
    Replacement replacement = Replacement::Lru;
    std::uint32_t replacement_seed = 1;
    IndexHash index_hash = IndexHash::Modulo;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        field("replacement",
              self.replacement,
              {.meaning = "which line of a full set gives way: the least recently used, the "
                          "oldest, one drawn by lot, or, in texel caches, the one that is best "
                          "in hindsight: the fewest misses that any choice can have",
               .choices = ReplacementNames});
        field("replacement_seed",
              self.replacement_seed,
              {.minimum = 0, .maximum = 0x7fffffff, .meaning = "random replacement: of its lots"});
        field("index_hash",
              self.index_hash,
              {.meaning = "modulo: the set is the lowest bits of the line's number; xor: all of "
                          "its bits folded onto them",
               .choices = IndexHashNames});
    }
};

// The set of a line. Folding spreads strides that are multiples of the number of sets.
class SetIndex {
public:
    SetIndex(std::uint32_t sets, IndexHash hash)
        : mask_(sets - 1)
        , fold_(hash == IndexHash::Xor && sets > 1) {
        for (std::uint32_t rest = mask_; rest != 0; rest >>= 1)
            ++bits_;
    }

    std::uint64_t operator()(std::uint64_t line) const {
        std::uint64_t index = line;
        for (std::uint64_t rest = line >> bits_; fold_ && rest != 0; rest >>= bits_)
            index ^= rest;
        return index & mask_;
    }

private:
    std::uint32_t mask_;
    unsigned bits_ = 0;
    bool fold_;
};

} // namespace ffgpu::work
