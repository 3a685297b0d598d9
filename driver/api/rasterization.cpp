// Points, lines and polygons (GL 1.5, 3.3 to 3.5), multisampling (3.2.1).

#include "driver/api/parameters.h"
#include "driver/commands/declarations.h"
#include "driver/context/context.h"
#include "driver/limits.h"
#include "driver/math/conversion.h"

#include <algorithm>

namespace ffgpu::gl::api {
namespace {

constexpr Parameter PointParameters[] = {
    {GL_POINT_SIZE_MIN, 1},
    {GL_POINT_SIZE_MAX, 1},
    {GL_POINT_FADE_THRESHOLD_SIZE, 1},
    {GL_POINT_DISTANCE_ATTENUATION, 3},
    {GL_POINT_SPRITE_COORD_ORIGIN, 1},
};

template <class Number>
void set_point_parameter(Context& context,
                         GLenum name,
                         const Number* params,
                         bool is_scalar = false) {
    const Parameter* const parameter = find_parameter(PointParameters, name);
    if (!parameter || (is_scalar && parameter->count > 1)) return context.error(GL_INVALID_ENUM);
    const Vec4 values = read_values(*parameter, params);
    PointState& point = context.state.rasterization.point;
    if (name == GL_POINT_DISTANCE_ATTENUATION) {
        point.attenuation = {values[0], values[1], values[2]};
    } else if (name == GL_POINT_SPRITE_COORD_ORIGIN) {
        const GLenum origin = to_enum(values[0]);
        if (origin != GL_LOWER_LEFT && origin != GL_UPPER_LEFT)
            return context.error(GL_INVALID_VALUE);
        point.sprite_origin = origin;
    } else {
        if (!(values[0] >= 0)) return context.error(GL_INVALID_VALUE);
        (name == GL_POINT_SIZE_MIN   ? point.size_min
         : name == GL_POINT_SIZE_MAX ? point.size_max
                                     : point.fade_threshold) = values[0];
    }
    context.dirty.mark(Dirty::Primitive);
}

} // namespace

void PointSize(Context& context, GLfloat size) {
    if (!(size > 0)) return context.error(GL_INVALID_VALUE);
    context.state.rasterization.point.size = size;
    context.dirty.mark(Dirty::Primitive);
}

void PointParameterf(Context& context, GLenum pname, GLfloat param) {
    set_point_parameter(context, pname, &param, true);
}

void PointParameteri(Context& context, GLenum pname, GLint param) {
    set_point_parameter(context, pname, &param, true);
}

void PointParameterfv(Context& context, GLenum pname, const GLfloat* params) {
    set_point_parameter(context, pname, params);
}

void PointParameteriv(Context& context, GLenum pname, const GLint* params) {
    set_point_parameter(context, pname, params);
}

void LineWidth(Context& context, GLfloat width) {
    if (!(width > 0)) return context.error(GL_INVALID_VALUE);
    context.state.rasterization.line.width = width;
    context.dirty.mark(Dirty::Primitive);
}

void LineStipple(Context& context, GLint factor, GLushort pattern) {
    LineState& line = context.state.rasterization.line;
    line.stipple_factor = std::clamp(factor, 1, 256);
    line.stipple_pattern = pattern;
    context.dirty.mark(Dirty::Primitive);
}

void CullFace(Context& context, GLenum mode) {
    if (mode != GL_FRONT && mode != GL_BACK && mode != GL_FRONT_AND_BACK)
        return context.error(GL_INVALID_ENUM);
    context.state.rasterization.polygon.cull_face = mode;
    context.dirty.mark(Dirty::Primitive);
}

void FrontFace(Context& context, GLenum mode) {
    if (mode != GL_CW && mode != GL_CCW) return context.error(GL_INVALID_ENUM);
    context.state.rasterization.polygon.front_face = mode;
    context.dirty.mark(Dirty::Primitive);
}

void PolygonMode(Context& context, GLenum face, GLenum mode) {
    if (face != GL_FRONT && face != GL_BACK && face != GL_FRONT_AND_BACK)
        return context.error(GL_INVALID_ENUM);
    if (mode != GL_POINT && mode != GL_LINE && mode != GL_FILL)
        return context.error(GL_INVALID_ENUM);
    auto& modes = context.state.rasterization.polygon.mode;
    if (face != GL_BACK) modes[0] = mode;
    if (face != GL_FRONT) modes[1] = mode;
    context.dirty.mark(Dirty::Primitive);
}

void PolygonOffset(Context& context, GLfloat factor, GLfloat units) {
    PolygonState& polygon = context.state.rasterization.polygon;
    polygon.offset_factor = factor;
    polygon.offset_units = units;
    context.dirty.mark(Dirty::Primitive);
}

// EXT_polygon_offset: its bias is in units of the depth range [0, 1], not of the buffer's.
void PolygonOffsetEXT(Context& context, GLfloat factor, GLfloat bias) {
    PolygonOffset(context, factor, bias * OffsetUnitsInRange);
}

// EXT_polygon_offset_clamp and EXT_provoking_vertex are not advertised: the device has neither.
void PolygonOffsetClampEXT(Context& context, GLfloat, GLfloat, GLfloat) {
    context.error(GL_INVALID_OPERATION);
}

void ProvokingVertex(Context& context, GLenum) {
    context.error(GL_INVALID_OPERATION);
}

void SampleCoverage(Context& context, GLfloat value, GLboolean invert) {
    MultisampleState& multisample = context.state.rasterization.multisample;
    multisample.coverage_value = clamp_unit(value);
    multisample.coverage_invert = invert != GL_FALSE;
    context.dirty.mark(Dirty::Fragment);
}

} // namespace ffgpu::gl::api
