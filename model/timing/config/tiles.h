// The configuration of a tile-based machine's own units: binner, parameter buffer, on-chip memory.

#pragma once

#include "model/base/parameters.h"
#include "model/work/tile_config.h"

#include <cstdint>
#include <string_view>

namespace ffgpu::timing {

struct TilesConfig : work::TileOrder {
    static constexpr std::string_view Name = "tiles";
    std::uint32_t entries_per_cycle = 1;
    std::uint32_t gathered_entries = 8;
    std::uint32_t parameter_buffers = 2;
    std::uint32_t fetch_ahead = 4;
    std::uint32_t entry_cycles = 1;
    std::uint32_t buffers = 2;
    std::uint32_t clear_pixels_per_cycle = 64;
    std::uint32_t lines_per_cycle = 1;
    std::uint32_t request_queue = 16;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        TileOrder::visit(self, field);
        visit_parameters(self, field);
        field("buffers",
              self.buffers,
              {.unit = "bins",
               .minimum = 1,
               .maximum = 16,
               .meaning = "on chip at once: 1: loads and stores wait for the drawing"});
        field("clear_pixels_per_cycle",
              self.clear_pixels_per_cycle,
              {.unit = "pixels/cycle",
               .minimum = 1,
               .maximum = 4096,
               .meaning = "that a clear on chip fills"});
        field("lines_per_cycle",
              self.lines_per_cycle,
              {.unit = "lines/cycle",
               .minimum = 1,
               .maximum = 64,
               .meaning = "that are asked for or sent to be stored"});
        field("request_queue",
              self.request_queue,
              {.unit = "requests",
               .minimum = 1,
               .maximum = 4096,
               .meaning = "of each of the units, on their way to the memory's arbiter"});
    }

private:
    template <class Self, class Visitor>
    static void visit_parameters(Self& self, Visitor&& field) {
        field("entries_per_cycle",
              self.entries_per_cycle,
              {.unit = "entries/cycle",
               .minimum = 1,
               .maximum = 64,
               .meaning = "that the binner puts into lists"});
        field("gathered_entries",
              self.gathered_entries,
              {.unit = "entries",
               .minimum = 1,
               .maximum = 256,
               .meaning = "of a bin's list that are written together"});
        field("parameter_buffers",
              self.parameter_buffers,
              {.unit = "buffers",
               .minimum = 1,
               .maximum = 8,
               .meaning = "one is filled while others are drawn"});
        field("fetch_ahead",
              self.fetch_ahead,
              {.unit = "bins",
               .minimum = 1,
               .maximum = 64,
               .meaning = "whose parameters are read back at once"});
        field("entry_cycles",
              self.entry_cycles,
              {.unit = "cycles",
               .minimum = 1,
               .maximum = 64,
               .meaning = "to set a primitive up again in a bin"});
    }
};

} // namespace ffgpu::timing
