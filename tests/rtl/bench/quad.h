// The bundles of rtl/ffgpu_pkg.sv.

#pragma once

#include "model/memory/pixel_format.h"
#include "tests/rtl/bench/fields.h"
#include "tests/rtl/bench/random.h"

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
    PerLane<std::uint32_t> primary{}, secondary{};
    PerLane<float> fog_coordinate{};
    std::array<std::uint32_t, 8 * Lanes> samples{}; // unit u, lane l: number 4 u + l

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        Quad::visit(self.quad, field);
        visit_lanes(field, "primary", self.primary, 32);
        visit_lanes(field, "secondary", self.secondary, 32);
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

inline std::uint32_t random_color(Random& random) {
    std::uint32_t color = 0;
    for (unsigned channel = 0; channel < 4; ++channel)
        color |= std::uint32_t{random.byte()} << 8 * channel;
    return color;
}

inline Quad random_quad(Random& random) {
    Quad quad{.draw = random.word(),
              .primitive = random.word(),
              .piece = random.word(),
              .x = static_cast<std::uint16_t>(random.below(4096) * 2),
              .y = static_cast<std::uint16_t>(random.below(4096) * 2),
              .live = static_cast<std::uint8_t>(random.below(16)),
              .front_facing = random.one_in(2)};
    for (unsigned lane = 0; lane < Lanes; ++lane) {
        quad.depth[lane] = random.word() >> 8;
        quad.coverage[lane] = random.byte();
        quad.color[lane] = random_color(random);
    }
    return quad;
}

inline ShadeQuad random_shade_quad(Random& random) {
    ShadeQuad shaded{.quad = random_quad(random)};
    for (unsigned lane = 0; lane < Lanes; ++lane) {
        shaded.primary[lane] = random_color(random);
        shaded.secondary[lane] = random_color(random);
        shaded.fog_coordinate[lane] = std::bit_cast<float>(random.word());
    }
    for (std::uint32_t& sample : shaded.samples)
        sample = random_color(random);
    return shaded;
}

} // namespace ffgpu::rtl
