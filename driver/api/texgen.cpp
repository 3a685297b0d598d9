// glTexGen and glGetTexGen (GL 1.5, 2.11.4).

#include "driver/api/parameters.h"
#include "driver/commands/declarations.h"
#include "driver/context/context.h"
#include "driver/math/matrix.h"

#include <array>

namespace ffgpu::gl::api {
namespace {

constexpr std::array Parameters{
    Parameter{GL_TEXTURE_GEN_MODE, 1},
    Parameter{GL_OBJECT_PLANE, 4},
    Parameter{GL_EYE_PLANE, 4},
};

TexGen* find_coordinate(Context& context, GLenum coord) {
    if (coord < GL_S || coord > GL_Q) return nullptr;
    return &context.state.texture.active().gen[coord - GL_S];
}

bool is_mode_of(GLenum coord, GLenum mode) {
    switch (mode) {
    case GL_OBJECT_LINEAR:
    case GL_EYE_LINEAR:
        return true;
    case GL_SPHERE_MAP:
        return coord == GL_S || coord == GL_T;
    case GL_NORMAL_MAP:
    case GL_REFLECTION_MAP:
        return coord != GL_Q;
    default:
        return false;
    }
}

template <class Value>
void set_texgen(Context& context, GLenum coord, GLenum name, const Value* params) {
    TexGen* const gen = find_coordinate(context, coord);
    const Parameter* const parameter = find_parameter(Parameters, name);
    if (!gen || !parameter) return context.error(GL_INVALID_ENUM);
    const Vec4 values = read_values(*parameter, params);
    if (name == GL_TEXTURE_GEN_MODE) {
        const GLenum mode = to_enum(values[0]);
        if (!is_mode_of(coord, mode)) return context.error(GL_INVALID_ENUM);
        gen->mode = mode;
    } else if (name == GL_OBJECT_PLANE) {
        gen->object_plane = values;
    } else {
        const Mat4& model_view = context.state.transform.matrices.model_view.top();
        gen->eye_plane = transform_plane(values, inverse(model_view));
    }
    context.dirty.mark(Dirty::TexGen);
}

void set_doubles(Context& context, GLenum coord, GLenum name, const GLdouble* params) {
    const Parameter* const parameter = find_parameter(Parameters, name);
    std::array<GLfloat, 4> values{};
    const std::size_t count = parameter ? parameter->count : 0;
    for (std::size_t i = 0; i < count; ++i)
        values[i] = static_cast<GLfloat>(params[i]);
    set_texgen(context, coord, name, values.data());
}

// Null: an enumerant is wrong, the error is recorded.
const Parameter* get_texgen(Context& context, GLenum coord, GLenum name, Vec4& values) {
    const TexGen* const gen = find_coordinate(context, coord);
    const Parameter* const parameter = find_parameter(Parameters, name);
    if (!gen || !parameter) {
        context.error(GL_INVALID_ENUM);
        return nullptr;
    }
    values = name == GL_TEXTURE_GEN_MODE ? Vec4{static_cast<float>(gen->mode)}
             : name == GL_OBJECT_PLANE   ? gen->object_plane
                                         : gen->eye_plane;
    return parameter;
}

} // namespace

void TexGenf(Context& context, GLenum coord, GLenum pname, GLfloat param) {
    set_texgen(context, coord, pname, Scalar(param).values);
}

void TexGeni(Context& context, GLenum coord, GLenum pname, GLint param) {
    set_texgen(context, coord, pname, Scalar(param).values);
}

void TexGend(Context& context, GLenum coord, GLenum pname, GLdouble param) {
    set_doubles(context, coord, pname, Scalar(param).values);
}

void TexGenfv(Context& context, GLenum coord, GLenum pname, const GLfloat* params) {
    set_texgen(context, coord, pname, params);
}

void TexGeniv(Context& context, GLenum coord, GLenum pname, const GLint* params) {
    set_texgen(context, coord, pname, params);
}

void TexGendv(Context& context, GLenum coord, GLenum pname, const GLdouble* params) {
    set_doubles(context, coord, pname, params);
}

void GetTexGenfv(Context& context, GLenum coord, GLenum pname, GLfloat* params) {
    Vec4 values;
    if (const Parameter* parameter = get_texgen(context, coord, pname, values))
        write_values(*parameter, values, params);
}

void GetTexGeniv(Context& context, GLenum coord, GLenum pname, GLint* params) {
    Vec4 values;
    if (const Parameter* parameter = get_texgen(context, coord, pname, values))
        write_values(*parameter, values, params);
}

void GetTexGendv(Context& context, GLenum coord, GLenum pname, GLdouble* params) {
    Vec4 values;
    const Parameter* const parameter = get_texgen(context, coord, pname, values);
    for (std::size_t i = 0; parameter && i < parameter->count; ++i)
        params[i] = static_cast<GLdouble>(values[i]);
}

} // namespace ffgpu::gl::api
