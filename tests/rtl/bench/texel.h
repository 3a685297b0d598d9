// texel_t of rtl/ffgpu_pkg.sv.

#pragma once

#include "tests/rtl/bench/fields.h"

namespace ffgpu::rtl {

struct Texel {
    bool tag = false;
    std::uint16_t place = 0;
    std::uint32_t color = 0;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        field("tag", self.tag, 1);
        field("place", self.place, 10);
        field("color", self.color, 32);
    }
};

} // namespace ffgpu::rtl
