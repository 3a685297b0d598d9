// What travels between the units of a tile-based machine.

#pragma once

#include "model/timing/tokens.h"

#include <cstdint>

namespace ffgpu::timing {

// A pass whose primitives are all in the parameter buffer.
struct PassToken {
    TimedScene* scene = nullptr;
    std::uint32_t pass = 0;
    std::uint32_t buffer = 0; // of the parameter buffers

    const work::TilePass& plan() const { return scene->work.tiles.passes[pass]; }
    bool is_last() const { return pass + 1 == scene->work.tiles.passes.size(); }
    std::string key() const;
};

// A bin of a pass. A pass without bins sends one that is empty.
struct BinToken {
    PassToken pass;
    std::uint32_t bin = 0; // index into TilePlan::bins
    bool empty = false;
    bool last_of_pass = false;

    const work::TileBin& plan() const { return pass.scene->work.tiles.bins[bin]; }
    std::string key() const;
};

} // namespace ffgpu::timing
