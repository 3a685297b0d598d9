// The bundles of rtl/ffgpu_pkg.sv.

#pragma once

#include "model/memory/pixel_format.h"
#include "rtl/bundles/fields.h"

#include <array>
#include <cstdint>

namespace ffgpu::rtl {

constexpr unsigned Lanes = 4;

template <class Value>
using PerLane = std::array<Value, Lanes>;

struct Quad {
    bool tag = false;
    std::uint32_t draw = 0, primitive = 0, piece = 0;
    std::uint16_t x = 0, y = 0;
    std::uint8_t live = 0;
    bool front_facing = false;
    PerLane<std::uint32_t> depth{};
    PerLane<std::uint8_t> coverage{};
    PerLane<std::uint32_t> color{};

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        field("tag", self.tag, 1);
        field("key.draw", self.draw, 32);
        field("key.primitive_number", self.primitive, 32);
        field("key.piece", self.piece, 32);
        field("x", self.x, 13);
        field("y", self.y, 13);
        field("live", self.live, 4);
        field("front_facing", self.front_facing, 1);
        visit_lanes(field, "depth", self.depth, 24);
        visit_lanes(field, "coverage", self.coverage, 8);
        visit_lanes(field, "color", self.color, 32);
    }

    bool is_live(unsigned lane) const { return (live >> lane & 1) != 0; }
    PixelColor rgba(unsigned lane) const { return unpack_rgba8(color[lane]); }
};

struct ShadeQuad {
    Quad quad;
    PerLane<std::uint32_t> primary{}, secondary{}; // the secondary has no alpha
    PerLane<float> fog_coordinate{};
    std::array<std::uint32_t, 8 * Lanes> samples{}; // unit u, lane l: number 4 u + l

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        Quad::visit(self.quad, field);
        visit_lanes(field, "primary", self.primary, 32);
        visit_lanes(field, "secondary", self.secondary, 24);
        visit_lanes(field, "fog_coordinate", self.fog_coordinate, 32);
        visit_lanes(field, "samples", self.samples, 32);
    }
};

struct TargetQuad {
    Quad quad;
    PerLane<std::uint32_t> pixels{};

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        Quad::visit(self.quad, field);
        visit_lanes(field, "pixels", self.pixels, 32);
    }
};

struct WrittenQuad {
    Quad quad;
    PerLane<std::uint32_t> pixels{};
    PerLane<std::uint8_t> enables{}; // a bit a byte

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        Quad::visit(self.quad, field);
        visit_lanes(field, "pixels", self.pixels, 32);
        visit_lanes(field, "enables", self.enables, 4);
    }
};

} // namespace ffgpu::rtl
