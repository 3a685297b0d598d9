// Fog (GL 1.5, 3.10), with NV_fog_distance.

#include "driver/api/parameters.h"
#include "driver/commands/declarations.h"
#include "driver/context/context.h"

namespace ffgpu::gl::api {
namespace {

constexpr Parameter FogParameters[] = {
    {GL_FOG_MODE, 1},
    {GL_FOG_DENSITY, 1},
    {GL_FOG_START, 1},
    {GL_FOG_END, 1},
    {GL_FOG_INDEX, 1},
    {GL_FOG_COLOR, 4, true},
    {GL_FOG_COORD_SRC, 1},
    {GL_FOG_DISTANCE_MODE_NV, 1},
};

bool is_legal(GLenum name, GLenum value) {
    switch (name) {
    case GL_FOG_MODE:
        return value == GL_LINEAR || value == GL_EXP || value == GL_EXP2;
    case GL_FOG_COORD_SRC:
        return value == GL_FOG_COORD || value == GL_FRAGMENT_DEPTH;
    case GL_FOG_DISTANCE_MODE_NV:
        return value == GL_EYE_RADIAL_NV || value == GL_EYE_PLANE ||
               value == GL_EYE_PLANE_ABSOLUTE_NV;
    default:
        return true;
    }
}

void set(FogState& fog, GLenum name, const Vec4& values) {
    switch (name) {
    case GL_FOG_MODE:
        fog.mode = to_enum(values[0]);
        break;
    case GL_FOG_DENSITY:
        fog.density = values[0];
        break;
    case GL_FOG_START:
        fog.start = values[0];
        break;
    case GL_FOG_END:
        fog.end = values[0];
        break;
    case GL_FOG_INDEX:
        fog.index = values[0];
        break;
    case GL_FOG_COLOR:
        for (std::size_t i = 0; i < 4; ++i)
            fog.color[i] = clamp_unit(values[i]);
        break;
    case GL_FOG_COORD_SRC:
        fog.coordinate_source = to_enum(values[0]);
        break;
    default:
        fog.distance_mode = to_enum(values[0]);
    }
}

template <class Number>
void set_fog(Context& context, GLenum name, const Number* params, bool is_scalar = false) {
    const Parameter* const parameter = find_parameter(FogParameters, name);
    if (!parameter || (is_scalar && parameter->count > 1)) return context.error(GL_INVALID_ENUM);
    const Vec4 values = read_values(*parameter, params);
    if (!is_legal(name, to_enum(values[0]))) return context.error(GL_INVALID_ENUM);
    if (name == GL_FOG_DENSITY && !(values[0] >= 0)) return context.error(GL_INVALID_VALUE);
    set(context.state.fragment.fog, name, values);
    context.dirty.mark(Dirty::Fragment);
}

} // namespace

void Fogf(Context& context, GLenum pname, GLfloat param) {
    set_fog(context, pname, &param, true);
}

void Fogi(Context& context, GLenum pname, GLint param) {
    set_fog(context, pname, &param, true);
}

void Fogfv(Context& context, GLenum pname, const GLfloat* params) {
    set_fog(context, pname, params);
}

void Fogiv(Context& context, GLenum pname, const GLint* params) {
    set_fog(context, pname, params);
}

} // namespace ffgpu::gl::api
