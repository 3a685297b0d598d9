// Registers of primitive assembly, culling and rasterization.

#pragma once

#include "model/device/layout/limits.h"

#include <array>
#include <cstdint>

namespace ffgpu {

enum class PolygonMode : std::uint8_t { Point, Line, Fill };

struct PrimitiveSetup {
    static constexpr const char* Name = "primitive_setup";

    bool flat_shading = false; // colours of the provoking vertex: the last, of polygons the first
    bool front_is_clockwise = false;
    bool cull_front = false;
    bool cull_back = false;
    PolygonMode front_mode = PolygonMode::Fill;
    PolygonMode back_mode = PolygonMode::Fill;
    bool offset_point = false;
    bool offset_line = false;
    bool offset_fill = false;
    float offset_factor = 0;
    float offset_units = 0;

    bool polygon_smooth = false;
    bool polygon_stipple = false;

    bool line_smooth = false;
    bool line_stipple = false;
    std::uint16_t line_stipple_pattern = 0xffff;
    std::uint16_t line_stipple_factor = 1; // 1 to 256
    float line_width = 1;                  // in pixels

    bool point_smooth = false;
    bool point_sprite = false;
    bool point_sprite_origin_lower_left = false;
    std::uint8_t point_sprite_replace = 0; // one bit a texture unit
    float point_size = 1;                  // in pixels
    float point_size_min = 0;
    float point_size_max = 1024;
    float point_fade_threshold = 1;
    std::array<float, 3> point_attenuation{1, 0, 0}; // constant, linear, quadratic

    template <class Self, class Visitor>
    static constexpr void visit(Self& self, Visitor&& field) {
        field("flat_shading", self.flat_shading, 1);
        field("front_is_clockwise", self.front_is_clockwise, 1);
        field("cull_front", self.cull_front, 1);
        field("cull_back", self.cull_back, 1);
        field("front_mode", self.front_mode, 2);
        field("back_mode", self.back_mode, 2);
        field("offset_point", self.offset_point, 1);
        field("offset_line", self.offset_line, 1);
        field("offset_fill", self.offset_fill, 1);
        field("polygon_smooth", self.polygon_smooth, 1);
        field("polygon_stipple", self.polygon_stipple, 1);
        field("line_smooth", self.line_smooth, 1);
        field("line_stipple", self.line_stipple, 1);
        field("point_smooth", self.point_smooth, 1);
        field("point_sprite", self.point_sprite, 1);
        field("point_sprite_origin_lower_left", self.point_sprite_origin_lower_left, 1);
        field("point_sprite_replace", self.point_sprite_replace, TextureUnits);
        field("line_stipple_pattern", self.line_stipple_pattern, 16);
        field("line_stipple_factor", self.line_stipple_factor, 9);
        field("offset_factor", self.offset_factor);
        field("offset_units", self.offset_units);
        field("line_width", self.line_width);
        field("point_size", self.point_size);
        field("point_size_min", self.point_size_min);
        field("point_size_max", self.point_size_max);
        field("point_fade_threshold", self.point_fade_threshold);
        for (auto& term : self.point_attenuation)
            field("point_attenuation", term);
    }
    bool operator==(const PrimitiveSetup&) const = default;
};

// rows[y mod 32], bit 31 - (x mod 32) set: the fragment is kept (GL 1.5, 3.5.2 reads the pattern
// as a bitmap, whose first pixel is the most significant bit).
struct PolygonStipple {
    static constexpr const char* Name = "polygon_stipple";

    std::array<std::uint32_t, 32> rows = [] {
        std::array<std::uint32_t, 32> all{};
        for (std::uint32_t& row : all)
            row = 0xffffffff;
        return all;
    }();

    template <class Self, class Visitor>
    static constexpr void visit(Self& self, Visitor&& field) {
        for (auto& row : self.rows)
            field("row", row, 32);
    }
    bool operator==(const PolygonStipple&) const = default;
};

// Fragments outside are not made. Always in force: the driver sets the whole target where GL's
// scissor test is off.
struct Scissor {
    static constexpr const char* Name = "scissor";

    std::int16_t x = 0, y = 0; // lower left corner, in pixels
    std::uint16_t width = 0, height = 0;

    template <class Self, class Visitor>
    static constexpr void visit(Self& self, Visitor&& field) {
        field("x", self.x, 16);
        field("y", self.y, 16);
        field("width", self.width, 16);
        field("height", self.height, 16);
    }
    bool operator==(const Scissor&) const = default;
};

} // namespace ffgpu
