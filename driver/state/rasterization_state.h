// Rasterization of points, lines and polygons (GL 1.5, chapter 3; state tables 6.11 and 6.12).

#pragma once

#include "driver/gl_types.h"

#include <array>
#include <cstdint>

namespace ffgpu::gl {

struct PointState { // GL_POINT_BIT
    bool smooth = false;
    float size = 1;
    float size_min = 0;
    float size_max = 256; // MaxPointSize of driver/limits.h
    float fade_threshold = 1;
    std::array<float, 3> attenuation{1, 0, 0}; // constant, linear, quadratic
    bool sprite = false;                       // ARB_point_sprite; GL_COORD_REPLACE is a unit's
    GLenum sprite_origin = GL_UPPER_LEFT;      // GL 2.0's GL_POINT_SPRITE_COORD_ORIGIN
};

struct LineState { // GL_LINE_BIT
    bool smooth = false;
    bool stipple = false;
    float width = 1;
    std::uint16_t stipple_pattern = 0xffff;
    GLint stipple_factor = 1;
};

struct PolygonState { // GL_POLYGON_BIT
    bool cull = false;
    GLenum cull_face = GL_BACK;
    GLenum front_face = GL_CCW;
    std::array<GLenum, 2> mode{GL_FILL, GL_FILL}; // front, back
    bool smooth = false;
    bool stipple = false;
    bool offset_point = false;
    bool offset_line = false;
    bool offset_fill = false;
    float offset_factor = 0;
    float offset_units = 0;
};

// GL_POLYGON_STIPPLE_BIT. rows[y]: the pattern's row y, its first pixel in bit 31.
using PolygonStipplePattern = std::array<std::uint32_t, 32>;

struct MultisampleState { // GL_MULTISAMPLE_BIT
    bool enable = true;
    bool alpha_to_coverage = false;
    bool alpha_to_one = false;
    bool sample_coverage = false;
    float coverage_value = 1;
    bool coverage_invert = false;
};

struct RasterizationState {
    PointState point;
    LineState line;
    PolygonState polygon;
    PolygonStipplePattern polygon_stipple = [] {
        PolygonStipplePattern all{};
        all.fill(0xffffffff);
        return all;
    }();
    MultisampleState multisample;
};

} // namespace ffgpu::gl
