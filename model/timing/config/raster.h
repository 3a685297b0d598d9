// The configuration of the rasterizer.

#pragma once

#include "model/base/parameters.h"
#include "model/work/config.h"

#include <array>
#include <cstdint>
#include <string_view>

namespace ffgpu::timing {

using work::Architecture;
using work::Traversal;

enum class Walk : std::uint8_t { Box, Tiles };
inline constexpr std::array<std::string_view, 2> WalkNames{"box", "tiles"};

struct RasterConfig : work::RasterOrder {
    static constexpr std::string_view Name = "raster";
    std::uint32_t quads_per_cycle = 1;
    std::uint32_t tile_cycles = 1;
    std::uint32_t empty_tile_cycles = 1;
    std::uint32_t block_queue = 16;
    Walk walk = Walk::Box;
    std::uint32_t piece_cycles = 0;
    std::uint32_t latency = 1;
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
        field("block_queue",
              self.block_queue,
              {.unit = "tiles",
               .minimum = 1,
               .maximum = 64,
               .meaning = "walk box: from the first step to one, or to a row or column, until its "
                          "last quad is made; 1: one after the other"});
        field("walk",
              self.walk,
              {.meaning =
                   "box: the blocks of a primitive's box, and the quads that it covers; tiles, for "
                   "nested and tile_width 8: all blocks of the outer tiles that the box touches, a "
                   "cycle each and one an outer tile, and in those that its edges touch all quads, "
                   "covered or not; what covers nothing does not come there",
               .choices = WalkNames});
        field("piece_cycles",
              self.piece_cycles,
              {.unit = "cycles",
               .minimum = 0,
               .maximum = 64,
               .meaning = "walk tiles: from a primitive's end to the next one's first tile"});
        field("latency",
              self.latency,
              {.unit = "cycles",
               .minimum = 1,
               .maximum = 1024,
               .meaning = "from a quad's place in the walk to the next unit"});
        field("queue",
              self.queue,
              {.unit = "quads",
               .minimum = 1,
               .maximum = 4096,
               .meaning = "between rasterizer and early depth"});
    }
};

} // namespace ffgpu::timing
