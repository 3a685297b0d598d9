// BinSequence: bins of the same targets that are drawn one after another in each tile, as if they
// were one, and what they read and write. That is nobody else's until they are drawn.

#pragma once

#include "model/gpu/bin.h"
#include "model/gpu/range_set.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace ffgpu {

struct BinSequence {
    std::vector<std::unique_ptr<Bin>> bins;
    RangeSet reads, writes;

    bool empty() const { return bins.empty(); }

    bool writes_to(std::uint64_t at, std::uint64_t bytes) const {
        return writes.overlaps(at, bytes);
    }
    bool uses(std::uint64_t at, std::uint64_t bytes) const {
        return writes.overlaps(at, bytes) || reads.overlaps(at, bytes);
    }

    // Sets `tiles` to those with work, in row order from the lower left.
    void busy_tiles(std::vector<std::uint32_t>& tiles) const;
};

} // namespace ffgpu
