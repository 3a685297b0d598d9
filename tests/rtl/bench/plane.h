// What the plane units give, and where they are asked.

#pragma once

#include "tests/rtl/bench/fields.h"
#include "tests/rtl/bench/random.h"

#include <array>

namespace ffgpu::rtl {

struct LaneValues {
    bool tag = false;
    std::uint16_t place = 0;
    std::array<std::uint32_t, 4> values{};

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        field("tag", self.tag, 1);
        field("place", self.place, 10);
        visit_lanes(field, "values", self.values, 32);
    }
};

struct LaneDepths {
    bool tag = false;
    std::uint16_t place = 0;
    std::array<std::uint32_t, 4> depths{};

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        field("tag", self.tag, 1);
        field("place", self.place, 10);
        visit_lanes(field, "depths", self.depths, 24);
    }
};

// Pixels from a reference pixel, near or as far as windows go.
inline std::int16_t random_offset(Random& random) {
    const std::uint32_t most = random.one_in(4) ? 16384 : 64;
    return static_cast<std::int16_t>(static_cast<int>(random.below(2 * most)) -
                                     static_cast<int>(most));
}

} // namespace ffgpu::rtl
