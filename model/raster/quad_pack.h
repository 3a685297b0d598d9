// The quads of a block that are covered, side by side: what a batch takes of a block.

#pragma once

#include "model/raster/coverage.h"

#include <cstdint>

namespace ffgpu {

constexpr unsigned BlockQuads = BlockQuadsAcross * BlockQuadsAcross;

struct PackedQuads {
    unsigned count = 0;
    BlockMask lanes = 0; // Four bits a quad, from the lowest on.
};

// Writes to x and y the places of the block's quads that have a bit in its mask, in order. There is
// room for BlockQuads of them, and what stands behind the last is overwritten.
PackedQuads pack_quads(const BlockCoverage& block, std::uint16_t* x, std::uint16_t* y);

// The same, quad by quad: the specification.
PackedQuads pack_quads_scalar(const BlockCoverage& block, std::uint16_t* x, std::uint16_t* y);

using PackQuads = PackedQuads (*)(const BlockCoverage&, std::uint16_t* x, std::uint16_t* y);

// The form for the instruction set that Highway chooses now.
PackQuads choose_pack_quads();

} // namespace ffgpu
