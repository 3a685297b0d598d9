#include "tools/explain/stippled_out.h"

#include "model/raster/sample_coverage.h"
#include "model/raster/smooth_coverage.h"
#include "model/raster/stipple.h"

#include <algorithm>

namespace ffgpu::tools {
namespace {

// The pixels of a block that the record covers, by the specification.
BlockMask covered(const SetupRecord& record, const Rectangle& block) {
    switch (record.coverage) {
    case CoverageKind::Centre: {
        TileCoverage tile;
        cover_tile_scalar(edge_set(record), block, tile);
        return tile.count == 0 ? 0 : tile.blocks[0].mask;
    }
    case CoverageKind::Samples:
    case CoverageKind::SamplePoint: {
        TileSampleCoverage tile;
        cover_tile_samples_scalar(record, block, tile);
        return tile.count == 0 ? 0 : tile.blocks[0].any();
    }
    default: {
        BlockAntialias antialias;
        return smooth_block_scalar(record, block.x0, block.y0, antialias);
    }
    }
}

} // namespace

bool is_stippled_out(const SetupRecord& record, const Registers& registers, int x, int y) {
    if (record.stipple == StippleKind::None) return false;
    const int left = x & -BlockSize, low = y & -BlockSize;
    const BlockMask pixel = BlockMask{1} << block_bit(x - left, y - low);
    const StipplePatterns patterns =
        stipple_patterns(registers.polygon_stipple, registers.primitive);
    if ((stipple_mask(record, patterns, left, low) & pixel) != 0) return false;
    return (covered(record, {left, low, left + BlockSize, low + BlockSize}) & pixel) != 0;
}

} // namespace ffgpu::tools
