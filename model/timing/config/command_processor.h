// The configuration of the command processor.

#pragma once

#include "model/base/parameters.h"

#include <cstdint>
#include <string_view>

namespace ffgpu::timing {

struct CommandProcessorConfig {
    static constexpr std::string_view Name = "command_processor";
    std::uint32_t draw_cycles = 16;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        field("draw_cycles",
              self.draw_cycles,
              {.unit = "cycles",
               .minimum = 1,
               .maximum = 65536,
               .meaning = "to decode a draw and its state"});
    }
};

} // namespace ffgpu::timing
