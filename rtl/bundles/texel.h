// From a texel's block to a sample.

#pragma once

#include "model/device/registers/texture.h"
#include "rtl/bundles/fields.h"

#include <array>
#include <cstdint>

namespace ffgpu::rtl {

struct TexelBlock {
    bool tag = false;
    std::uint16_t place = 0;
    bool is_border = false;
    Format format = Format::None;
    bool srgb = false, compare_enable = false;
    Compare relation = Compare::Never;
    DepthMode depth_mode = DepthMode::Luminance;
    std::uint32_t reference = 0;
    std::uint8_t x = 0, y = 0;
    std::array<std::uint32_t, 4> block{};

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        field("tag", self.tag, 1);
        field("place", self.place, 10);
        field("is_border", self.is_border, 1);
        field("format", self.format, 5);
        field("srgb", self.srgb, 1);
        field("compare_enable", self.compare_enable, 1);
        field("relation", self.relation, 3);
        field("depth_mode", self.depth_mode, 2);
        field("depth_reference", self.reference, 24);
        field("x", self.x, 3);
        field("y", self.y, 2);
        visit_lanes(field, "block", self.block, 32);
    }
};

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

struct FilterLevel {
    bool tag = false;
    std::uint16_t place = 0;
    bool last_level = true, last_probe = true;
    std::uint8_t probes = 1;
    std::uint8_t level_weight = 0, weight_z = 0, weight_y = 0, weight_x = 0;
    std::array<std::uint32_t, 8> texels{}; // number 4 z + 2 y + x

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        field("tag", self.tag, 1);
        field("place", self.place, 10);
        field("last_level", self.last_level, 1);
        field("last_probe", self.last_probe, 1);
        field("probes", self.probes, 5);
        field("level_weight", self.level_weight, 8);
        field("weight_z", self.weight_z, 8);
        field("weight_y", self.weight_y, 8);
        field("weight_x", self.weight_x, 8);
        visit_lanes(field, "texels", self.texels, 32);
    }
};

} // namespace ffgpu::rtl
