// The configuration of primitive set-up.

#pragma once

#include "model/base/parameters.h"

#include <cstdint>
#include <string_view>

namespace ffgpu::timing {

struct SetupConfig {
    static constexpr std::string_view Name = "setup";
    std::uint32_t triangle_cycles = 2;
    std::uint32_t reject_cycles = 1;
    std::uint32_t queue = 16;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        field(
            "triangle_cycles",
            self.triangle_cycles,
            {.unit = "cycles", .minimum = 1, .maximum = 1024, .meaning = "to set up a primitive"});
        field("reject_cycles",
              self.reject_cycles,
              {.unit = "cycles",
               .minimum = 1,
               .maximum = 1024,
               .meaning = "for a primitive that is clipped away or culled"});
        field("queue",
              self.queue,
              {.unit = "primitives",
               .minimum = 1,
               .maximum = 4096,
               .meaning = "between geometry and set-up"});
    }
};

} // namespace ffgpu::timing
