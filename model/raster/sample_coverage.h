// Traversal of multisampled targets: which samples of a tile's pixels a primitive covers.
//
// A sample is a centre moved by its position, and the edges moved the other way are the edges of an
// ordinary traversal: the tile is walked once a sample, and the four walks are put together.

#pragma once

#include "model/raster/coverage.h"
#include "model/raster/sample_positions.h"

#include <array>
#include <cstdint>

namespace ffgpu {

struct SampleBlock {
    std::uint16_t x, y;                      // window pixel of the block's lower left
    std::array<BlockMask, MaxSamples> masks; // one a sample, not all of them 0

    BlockMask any() const { return masks[0] | masks[1] | masks[2] | masks[3]; }
};

// Blocks with a covered sample, row by row from the tile's lower left.
struct TileSampleCoverage {
    unsigned count = 0;
    std::array<SampleBlock, MaxTileBlocks> blocks;
};

// CoverageKind::Samples and SamplePoint; for the rest as cover_tile().
void cover_tile_samples(const SetupRecord& record,
                        const Rectangle& tile,
                        TileSampleCoverage& coverage);

// The same, sample by sample: the specification.
void cover_tile_samples_scalar(const SetupRecord& record,
                               const Rectangle& tile,
                               TileSampleCoverage& coverage);

} // namespace ffgpu
