// What the plane units take and give.

#pragma once

#include "rtl/bundles/fields.h"

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

struct PlaneQuad {
    bool tag = false;
    std::uint16_t place = 0;
    std::int16_t x = 0, y = 0;
    std::int32_t whole = 0;
    std::uint32_t fraction = 0;
    std::int64_t dx = 0, dy = 0;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        field("tag", self.tag, 1);
        field("place", self.place, 10);
        field("x", self.x, 15);
        field("y", self.y, 15);
        field("whole", self.whole, 32);
        field("fraction", self.fraction, 14);
        field("dx", self.dx, 45);
        field("dy", self.dy, 45);
    }
};

struct DepthPlaneQuad {
    bool tag = false;
    std::uint16_t place = 0;
    std::int16_t x = 0, y = 0;
    std::int64_t origin = 0, dx = 0, dy = 0;
    std::uint32_t depth_min = 0, depth_max = 0;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        field("tag", self.tag, 1);
        field("place", self.place, 10);
        field("x", self.x, 15);
        field("y", self.y, 15);
        field("origin", self.origin, 64);
        field("dx", self.dx, 64);
        field("dy", self.dy, 64);
        field("depth_min", self.depth_min, 24);
        field("depth_max", self.depth_max, 24);
    }
};

enum class PerspectiveKind : std::uint8_t { Coordinate, Color, Fog, InverseW, Q };

struct PerspectiveQuad {
    bool tag = false;
    std::uint16_t place = 0;
    PerspectiveKind kind = PerspectiveKind::Coordinate;
    std::int32_t floor = 0;
    std::uint8_t scale = 127;
    std::array<float, 4> factors{1, 1, 1, 1};
    std::array<std::int32_t, 4> values{};

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        field("tag", self.tag, 1);
        field("place", self.place, 10);
        field("kind", self.kind, 3);
        field("floor", self.floor, 32);
        field("scale", self.scale, 8);
        visit_lanes(field, "factors", self.factors, 32);
        visit_lanes(field, "values", self.values, 32);
    }
};

} // namespace ffgpu::rtl
