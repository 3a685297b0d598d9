// The configuration of the rasterizer.

#pragma once

#include "model/base/parameters.h"
#include "model/work/config.h"

#include <cstdint>
#include <string_view>

namespace ffgpu::timing {

using work::Architecture;
using work::Traversal;

struct RasterConfig : work::RasterOrder {
    static constexpr std::string_view Name = "raster";
    std::uint32_t quads_per_cycle = 1;
    std::uint32_t tile_cycles = 1;
    std::uint32_t empty_tile_cycles = 1;
    std::uint32_t queue = 64;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        RasterOrder::visit(self, field);
        field("quads_per_cycle",
              self.quads_per_cycle,
              {.unit = "quads/cycle",
               .minimum = 1,
               .maximum = 16,
               .meaning = "of the rasterizer, and the number of fragment pipes: each with its own "
                          "look-ups, filters and environments"});
        field("tile_cycles",
              self.tile_cycles,
              {.unit = "cycles",
               .minimum = 0,
               .maximum = 64,
               .meaning = "to step to a tile, row or column of a primitive that holds quads"});
        field("empty_tile_cycles",
              self.empty_tile_cycles,
              {.unit = "cycles",
               .minimum = 0,
               .maximum = 64,
               .meaning =
                   "to step over one of a primitive's box that holds none; 0: such tiles are "
                   "not walked"});
        field("queue",
              self.queue,
              {.unit = "quads",
               .minimum = 1,
               .maximum = 4096,
               .meaning = "between rasterizer and early depth"});
    }
};

} // namespace ffgpu::timing
