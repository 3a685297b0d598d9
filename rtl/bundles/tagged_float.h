// tagged_float_t of rtl/ffgpu_pkg.sv.

#pragma once

#include "rtl/bundles/fields.h"

namespace ffgpu::rtl {

struct TaggedFloat {
    bool tag = false;
    std::uint16_t place = 0;
    float value = 1;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        field("tag", self.tag, 1);
        field("place", self.place, 10);
        field("value", self.value, 32);
    }
};

} // namespace ffgpu::rtl
