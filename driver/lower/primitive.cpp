#include "driver/lower/primitive.h"

#include "driver/limits.h"

#include <algorithm>

namespace ffgpu::gl {
namespace {

::ffgpu::PolygonMode lower_mode(GLenum mode) {
    switch (mode) {
    case GL_POINT:
        return PolygonMode::Point;
    case GL_LINE:
        return PolygonMode::Line;
    default:
        return PolygonMode::Fill;
    }
}

void lower_points(const PointState& gl, const TextureState& texture, PrimitiveSetup& registers) {
    registers.point_smooth = gl.smooth;
    registers.point_size = gl.size;
    // GL 1.5, 3.3: min beyond max is undefined; then max wins. The device's own range comes last.
    registers.point_size_max = std::clamp(gl.size_max, 1.0f, MaxPointSize);
    registers.point_size_min = std::min(gl.size_min, registers.point_size_max);
    registers.point_fade_threshold = gl.fade_threshold;
    registers.point_attenuation = gl.attenuation;
    registers.point_sprite = gl.sprite;
    registers.point_sprite_origin_lower_left = gl.sprite_origin == GL_LOWER_LEFT;
    for (unsigned unit = 0; unit < TextureUnits; ++unit) {
        if (gl.sprite && texture.units[unit].environment.coord_replace)
            registers.point_sprite_replace |= static_cast<std::uint8_t>(1u << unit);
    }
}

void lower_lines(const LineState& gl, PrimitiveSetup& registers) {
    registers.line_smooth = gl.smooth;
    registers.line_stipple = gl.stipple;
    registers.line_stipple_pattern = gl.stipple_pattern;
    registers.line_stipple_factor = static_cast<std::uint16_t>(gl.stipple_factor);
    registers.line_width = std::clamp(gl.width, 1.0f, MaxLineWidth);
}

void lower_polygons(const PolygonState& gl, PrimitiveSetup& registers) {
    registers.front_is_clockwise = gl.front_face == GL_CW;
    registers.cull_front = gl.cull && gl.cull_face != GL_BACK;
    registers.cull_back = gl.cull && gl.cull_face != GL_FRONT;
    registers.front_mode = lower_mode(gl.mode[0]);
    registers.back_mode = lower_mode(gl.mode[1]);
    registers.offset_point = gl.offset_point;
    registers.offset_line = gl.offset_line;
    registers.offset_fill = gl.offset_fill;
    registers.offset_factor = gl.offset_factor;
    registers.offset_units = gl.offset_units;
    registers.polygon_smooth = gl.smooth;
    registers.polygon_stipple = gl.stipple;
}

} // namespace

PrimitiveSetup
lower_primitive(const RasterizationState& gl, const TextureState& texture, GLenum shade_model) {
    PrimitiveSetup registers;
    registers.flat_shading = shade_model == GL_FLAT;
    lower_points(gl.point, texture, registers);
    lower_lines(gl.line, registers);
    lower_polygons(gl.polygon, registers);
    return registers;
}

PolygonStipple lower_polygon_stipple(const RasterizationState& gl) {
    return {.rows = gl.polygon_stipple};
}

} // namespace ffgpu::gl
