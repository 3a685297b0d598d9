// TilePlan: how a tile-based machine draws a scene: which primitives it writes down, in the lists
// of which bins, and of each bin what is loaded, drawn and stored.
//
// A scene is drawn in one pass; where its parameters do not fit the parameter buffer, in several:
// each draws what was binned until then and stores it all, since nobody knows what comes.
//
// Bytes of a pass in the parameter buffer: bins x header + records x record + entries x entry.

#pragma once

#include "model/work/surface_fill.h"

#include <cstdint>
#include <vector>

namespace ffgpu::work {

// A piece of memory that moves at once: a line, or what of it belongs to a bin.
struct PlacedLine {
    std::uint64_t address = 0;
    std::uint32_t bytes = 0;
    bool depth = false;
};

// A piece of a primitive that is set up (an image, or a clear that comes after other work), as it
// is written to the parameter buffer: once, with an entry for each bin.
struct TileRecord {
    std::uint32_t draw = 0;                     // index into PreparedScene::draws
    std::uint32_t piece = 0;                    // and into its pieces
    std::uint32_t bins_begin = 0, bins_end = 0; // into TilePlan::record_bins
};

struct TileBin {
    std::uint16_t x = 0, y = 0; // window pixel of the lower left corner
    std::uint32_t quads_begin = 0, quads_end = 0;
    std::uint32_t pieces_begin = 0, pieces_end = 0; // that are walked
    std::uint32_t list_begin = 0, list_end = 0;     // into TilePlan::lists
    std::uint32_t clears = 0;                       // done on chip
    std::uint32_t loads_begin = 0, loads_end = 0, stores_begin = 0, stores_end = 0; // lines
};

// What a clear of the scene does to a target in one bin, before the quad of that index is drawn.
struct TileFill {
    std::uint32_t quad = 0;
    SurfaceFill fill;
};

struct TilePass {
    std::uint32_t records_begin = 0, records_end = 0;
    std::uint32_t bins_begin = 0, bins_end = 0;
};

struct TilePlan {
    std::vector<TileRecord> records;
    std::vector<std::uint32_t> record_bins; // index into bins
    std::vector<TilePass> passes;           // empty: not a tile-based machine's scene
    std::vector<TileBin> bins;              // of a pass in row order
    std::vector<std::uint32_t> lists;       // a bin's records in their order
    std::vector<PlacedLine> lines;          // to load and to store
    std::vector<TileFill> fills;            // in the order of their quads
    std::uint32_t needless_stores = 0;      // of bins, that a clear took the reason from
};

} // namespace ffgpu::work
