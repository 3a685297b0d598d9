// Traversal: which pixels of a tile a primitive covers.
//
// A tile is walked in blocks of 8x8 pixels. An edge that the whole tile is inside of is dropped, a
// block that lies outside one edge is skipped, one that lies inside all is full; the edge functions
// are evaluated for the pixels of the others only. Inside a tile they fit 32 bits.

#pragma once

#include "model/raster/setup_record.h"

#include <array>
#include <cstdint>
#include <span>

namespace ffgpu {

constexpr int BlockSize = 8;
constexpr unsigned BlockQuadsAcross = BlockSize / 2;
constexpr int MaxTileSize = 128;
constexpr unsigned MaxTileBlocks = (MaxTileSize / BlockSize) * (MaxTileSize / BlockSize);

// One bit a pixel of a block, in the order of a FragmentBatch: bit 4 q + i is lane i of quad q,
// quads row by row from the lowest.
using BlockMask = std::uint64_t;
constexpr BlockMask FullBlock = ~BlockMask{0};

constexpr unsigned block_bit(int x, int y) {
    return static_cast<unsigned>((y / 2 * 4 + x / 2) * 4 + (y % 2) * 2 + x % 2);
}

struct BlockCoverage {
    std::uint16_t x, y; // window pixel of the block's lower left
    BlockMask mask;     // never 0
};

// Covered blocks of one tile, row by row from its lower left.
struct TileCoverage {
    unsigned count = 0;
    std::array<BlockCoverage, MaxTileBlocks> blocks;
};

// The pixels of a box that lie inside edges.
struct EdgeSet {
    Rectangle box;
    std::span<const Edge> edges; // up to MaxEdges
};

inline EdgeSet edge_set(const SetupRecord& record) {
    return {record.box, {record.edges.data(), record.edge_count}};
}

// Pixels whose centres lie inside. `tile` begins at multiples of BlockSize and is at most
// MaxTileSize wide and high. Stipples are not applied.
void cover_tile(const EdgeSet& edges, const Rectangle& tile, TileCoverage& coverage);

// The same, pixel by pixel: the specification.
void cover_tile_scalar(const EdgeSet& edges, const Rectangle& tile, TileCoverage& coverage);

// The form of cover_tile() for the instruction set that Highway chooses now.
using CoverTileForm = void (*)(const EdgeSet&, const Rectangle& tile, TileCoverage&);
CoverTileForm choose_cover_tile();

// The pixels of the block at (x, y) that lie inside `rectangle`.
BlockMask rectangle_mask(const Rectangle& rectangle, int x, int y);

// False where the tile is certainly outside an edge.
bool may_touch(const SetupRecord& record, const Rectangle& tile);

} // namespace ffgpu
