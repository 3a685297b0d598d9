// The configuration of primitive set-up.

#pragma once

#include "model/base/parameters.h"

#include <cstdint>
#include <string_view>

namespace ffgpu::timing {

struct SetupConfig {
    static constexpr std::string_view Name = "setup";
    std::uint32_t units = 1;
    std::uint32_t triangle_cycles = 2;
    std::uint32_t attribute_cycles = 0;
    std::uint32_t plane_cycles = 0;
    std::uint32_t reject_cycles = 1;
    std::uint32_t queue = 16;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        field("units",
              self.units,
              {.unit = "units",
               .minimum = 1,
               .maximum = 16,
               .meaning = "set-up units side by side; as many primitives a cycle leave geometry "
                          "and the clipper"});
        field("triangle_cycles",
              self.triangle_cycles,
              {.unit = "cycles",
               .minimum = 1,
               .maximum = 1024,
               .meaning = "of a unit to set up a point, a line or a triangle"});
        field("attribute_cycles",
              self.attribute_cycles,
              {.unit = "cycles",
               .minimum = 0,
               .maximum = 64,
               .meaning = "more for each attribute that is interpolated, beside depth"});
        field("plane_cycles",
              self.plane_cycles,
              {.unit = "cycles",
               .minimum = 0,
               .maximum = 64,
               .meaning =
                   "more for each plane of this primitive: of attributes that differ between "
                   "its vertices, and of 1/w where it has perspective"});
        field("reject_cycles",
              self.reject_cycles,
              {.unit = "cycles",
               .minimum = 1,
               .maximum = 1024,
               .meaning = "for a primitive that is culled or without area"});
        field("queue",
              self.queue,
              {.unit = "primitives",
               .minimum = 1,
               .maximum = 4096,
               .meaning = "between the clipper and set-up, and between set-up and the rasterizer"});
    }
};

} // namespace ffgpu::timing
