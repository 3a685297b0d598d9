// The configuration of the command processor.

#pragma once

#include "model/base/parameters.h"

#include <cstdint>
#include <string_view>

namespace ffgpu::timing {

struct CommandProcessorConfig {
    static constexpr std::string_view Name = "command_processor";
    std::uint32_t draw_cycles = 16;
    std::uint32_t lines_per_cycle = 1;
    bool drains = false;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        field("draw_cycles",
              self.draw_cycles,
              {.unit = "cycles",
               .minimum = 1,
               .maximum = 65536,
               .meaning = "to decode a draw and its state"});
        field("lines_per_cycle",
              self.lines_per_cycle,
              {.unit = "lines a cycle",
               .minimum = 1,
               .maximum = 64,
               .meaning = "of clears, copies, images and write-backs that it asks the memory for"});
        field("drains",
              self.drains,
              {.meaning = "a draw, of a tile_based machine a scene, begins when the one before has "
                          "left the pipe; off: they follow each other"});
    }
};

} // namespace ffgpu::timing
