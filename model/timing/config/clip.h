// The configuration of the clipper.

#pragma once

#include "model/base/parameters.h"

#include <cstdint>
#include <string_view>

namespace ffgpu::timing {

struct ClipConfig {
    static constexpr std::string_view Name = "clip";
    std::uint32_t plane_cycles = 4;
    std::uint32_t queue = 16;
    // No parameter: those of a machine that this one is compared with (without_limit.h); 0: its
    // own.
    std::uint32_t kept_places = 0;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        field("plane_cycles",
              self.plane_cycles,
              {.unit = "cycles",
               .minimum = 0,
               .maximum = 1024,
               .meaning = "for each plane that a primitive is cut against, of the sides of the "
                          "view all four where one is crossed; primitives that need no cut pass, "
                          "setup.units a cycle"});
        field("queue",
              self.queue,
              {.unit = "primitives",
               .minimum = 1,
               .maximum = 4096,
               .meaning = "between geometry and the clipper"});
    }
};

} // namespace ffgpu::timing
