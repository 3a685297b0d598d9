// BinUnderWay: a bin that other threads draw while the next one is filled. What it reads and writes
// is nobody else's until it is done.

#pragma once

#include "model/gpu/bin.h"
#include "model/gpu/range_set.h"

#include <cstdint>

namespace ffgpu {

struct BinUnderWay {
    Bin bin;
    RangeSet reads, writes;
    bool busy = false;

    BinUnderWay(int tile_size, std::size_t arena_bytes)
        : bin(tile_size, arena_bytes) {}

    bool writes_to(std::uint64_t at, std::uint64_t bytes) const {
        return busy && writes.overlaps(at, bytes);
    }
    bool uses(std::uint64_t at, std::uint64_t bytes) const {
        return busy && (writes.overlaps(at, bytes) || reads.overlaps(at, bytes));
    }
};

} // namespace ffgpu
