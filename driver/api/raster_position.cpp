// The current raster position (GL 1.5, 2.13; window positions 2.13, MESA_window_pos).

#include "driver/commands/declarations.h"
#include "driver/context/context.h"
#include "driver/feedback/render_modes.h"
#include "driver/raster_position/host_vertex.h"
#include "driver/vertex/component.h"

#include <algorithm>
#include <cmath>

namespace ffgpu::gl::api {
namespace {

bool takes_fog_coordinate(const Context& context) {
    return context.state.fragment.fog.coordinate_source == GL_FOG_COORDINATE;
}

float window_depth(const ffgpu::Viewport& viewport, float unit) {
    return viewport.near_depth + unit * (viewport.far_depth - viewport.near_depth);
}

// Transforms and lights a vertex. Where it is clipped away, the position is not valid.
void raster_position(Context& context, float x, float y, float z = 0, float w = 1) {
    if (context.fails_inside_begin()) return;
    context.lower_state();
    const Registers& registers = context.registers.wanted;
    const CurrentState& current = context.state.current;
    const Vec4 object{x, y, z, w};
    const EyeVertex vertex = transform_vertex(registers, object, current.of(Attribute::Normal));
    RasterPosition& raster = context.state.current.raster;
    raster.valid = is_inside(registers, vertex);
    if (!raster.valid) return;

    const ffgpu::Viewport& viewport = registers.viewport;
    const Vec4& clip = vertex.clip;
    raster.position = {viewport.x + (clip[0] / clip[3] + 1) / 2 * viewport.width,
                       viewport.y + (clip[1] / clip[3] + 1) / 2 * viewport.height,
                       window_depth(viewport, clamp_unit((clip[2] / clip[3] + 1) / 2)),
                       clip[3]};
    raster.distance = takes_fog_coordinate(context) ? current.of(Attribute::FogCoordinate)[0]
                                                    : std::abs(vertex.position[2]);
    const LitColors colors = light_vertex(
        registers, vertex, current.of(Attribute::Color), current.of(Attribute::SecondaryColor));
    raster.color = colors.primary;
    raster.secondary_color = colors.secondary;
    raster.color_index = current.color_index;
    for (unsigned unit = 0; unit < TextureUnits; ++unit)
        raster.tex_coords[unit] = texture_coordinates(
            registers.tex_coords[unit], object, vertex, current.of(tex_coord(unit)));
    context.render_modes().raster_position_set();
}

Vec4 clamped(const Vec4& color) {
    Vec4 result{};
    std::transform(
        color.begin(), color.end(), result.begin(), [](float c) { return clamp_unit(c); });
    return result;
}

// In window coordinates: always valid; attributes come as they are.
void window_position(Context& context, float x, float y, float z = 0, float w = 1) {
    if (context.fails_inside_begin()) return;
    context.lower_state();
    CurrentState& current = context.state.current;
    RasterPosition& raster = current.raster;
    raster.valid = true;
    raster.position = {x, y, window_depth(context.registers.wanted.viewport, clamp_unit(z)), w};
    raster.distance =
        takes_fog_coordinate(context) ? current.of(Attribute::FogCoordinate)[0] : 0.0f;
    raster.color = clamped(current.of(Attribute::Color));
    raster.secondary_color = clamped(current.of(Attribute::SecondaryColor));
    raster.color_index = current.color_index;
    for (unsigned unit = 0; unit < TextureUnits; ++unit)
        raster.tex_coords[unit] = current.of(tex_coord(unit));
    context.render_modes().raster_position_set();
}

} // namespace

#define RASTER_POSITION_COMMANDS(suffix, type)                                                     \
    void RasterPos2##suffix(Context& context, type x, type y) {                                    \
        raster_position(context, plain(x), plain(y));                                              \
    }                                                                                              \
    void RasterPos3##suffix(Context& context, type x, type y, type z) {                            \
        raster_position(context, plain(x), plain(y), plain(z));                                    \
    }                                                                                              \
    void RasterPos4##suffix(Context& context, type x, type y, type z, type w) {                    \
        raster_position(context, plain(x), plain(y), plain(z), plain(w));                          \
    }                                                                                              \
    void RasterPos2##suffix##v(Context& context, const type* v) {                                  \
        RasterPos2##suffix(context, v[0], v[1]);                                                   \
    }                                                                                              \
    void RasterPos3##suffix##v(Context& context, const type* v) {                                  \
        RasterPos3##suffix(context, v[0], v[1], v[2]);                                             \
    }                                                                                              \
    void RasterPos4##suffix##v(Context& context, const type* v) {                                  \
        RasterPos4##suffix(context, v[0], v[1], v[2], v[3]);                                       \
    }                                                                                              \
    void WindowPos2##suffix(Context& context, type x, type y) {                                    \
        window_position(context, plain(x), plain(y));                                              \
    }                                                                                              \
    void WindowPos3##suffix(Context& context, type x, type y, type z) {                            \
        window_position(context, plain(x), plain(y), plain(z));                                    \
    }                                                                                              \
    void WindowPos4##suffix##MESA(Context& context, type x, type y, type z, type w) {              \
        window_position(context, plain(x), plain(y), plain(z), plain(w));                          \
    }                                                                                              \
    void WindowPos2##suffix##v(Context& context, const type* v) {                                  \
        WindowPos2##suffix(context, v[0], v[1]);                                                   \
    }                                                                                              \
    void WindowPos3##suffix##v(Context& context, const type* v) {                                  \
        WindowPos3##suffix(context, v[0], v[1], v[2]);                                             \
    }                                                                                              \
    void WindowPos4##suffix##vMESA(Context& context, const type* v) {                              \
        WindowPos4##suffix##MESA(context, v[0], v[1], v[2], v[3]);                                 \
    }

RASTER_POSITION_COMMANDS(s, GLshort)
RASTER_POSITION_COMMANDS(i, GLint)
RASTER_POSITION_COMMANDS(f, GLfloat)
RASTER_POSITION_COMMANDS(d, GLdouble)

} // namespace ffgpu::gl::api
