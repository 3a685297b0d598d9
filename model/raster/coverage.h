// Traversal: which pixels of a tile a primitive covers.
//
// A tile is walked in blocks of 8x8 pixels. An edge that the whole tile is inside of is dropped, a
// block that lies outside one edge is skipped, one that lies inside all is full; the edge functions
// are evaluated for the pixels of the others only. Inside a tile they fit 32 bits.

#pragma once

#include "model/raster/setup_record.h"

#include <algorithm>
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
    BlockMask mask;     // never 0 in a TileCoverage
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

// Primitives of few pixels need not be taken block by block: what they cover in a tile lies in one
// to four windows of 8x8 pixels that begin at even pixels, and come as if they were blocks.
//
// What an edge adds inside a window must fit 16 bits.
constexpr int SteepestInWindow = 0x7fff / (BlockSize - 1);

inline bool fits_windows(const SetupRecord& record) {
    constexpr int Most = 2 * BlockSize;
    const auto steepness = [&](unsigned i) {
        const Edge& edge = record.edges[i];
        return (edge.a < 0 ? -edge.a : edge.a) + (edge.b < 0 ? -edge.b : edge.b);
    };
    const Rectangle& box = record.box;
    return record.edge_count == 3 && box.x1 - (box.x0 & ~1) <= Most &&
           box.y1 - (box.y0 & ~1) <= Most && steepness(0) <= SteepestInWindow &&
           steepness(1) <= SteepestInWindow && steepness(2) <= SteepestInWindow;
}

// The windows of a primitive that fits; those with nothing covered are left out.
void cover_windows(const EdgeSet& edges, const Rectangle& tile, TileCoverage& coverage);
void cover_windows_scalar(const EdgeSet& edges, const Rectangle& tile, TileCoverage& coverage);

// The form for the instruction set that Highway chooses now.
CoverTileForm choose_cover_windows();

// Pixels of a block at x >= i, and at y >= i.
struct BlockBounds {
    std::array<BlockMask, BlockSize + 1> from_x{}, from_y{};

    constexpr BlockBounds() {
        for (int i = 0; i <= BlockSize; ++i)
            for (int y = 0; y < BlockSize; ++y)
                for (int x = 0; x < BlockSize; ++x) {
                    const BlockMask bit = BlockMask{1} << block_bit(x, y);
                    if (x >= i) from_x[static_cast<unsigned>(i)] |= bit;
                    if (y >= i) from_y[static_cast<unsigned>(i)] |= bit;
                }
    }
};
inline constexpr BlockBounds Bounds;

// The pixels of the block at (x, y) that lie inside `rectangle`.
inline BlockMask rectangle_mask(const Rectangle& rectangle, int x, int y) {
    const auto bound = [](int at) { return static_cast<unsigned>(std::clamp(at, 0, BlockSize)); };
    return Bounds.from_x[bound(rectangle.x0 - x)] & ~Bounds.from_x[bound(rectangle.x1 - x)] &
           Bounds.from_y[bound(rectangle.y0 - y)] & ~Bounds.from_y[bound(rectangle.y1 - y)];
}

// Blocks of BlockSize pixels that neither the box nor an edge rules out as a whole: those in which
// a rasterizer that works by blocks looks for pixels.
std::uint32_t touched_blocks(const EdgeSet& edges);

// False where the tile is certainly outside an edge.
bool may_touch(const SetupRecord& record, const Rectangle& tile);

} // namespace ffgpu
