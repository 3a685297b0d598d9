// glTexParameter and glGetTexParameter (GL 1.5, 3.8.4, table 3.19).

#include "driver/api/parameters.h"
#include "driver/commands/declarations.h"
#include "driver/context/context.h"
#include "driver/images/image_commands.h"
#include "driver/objects/texture_object.h"

#include <algorithm>
#include <array>

namespace ffgpu::gl::api {
namespace {

constexpr std::array Parameters{
    Parameter{GL_TEXTURE_MIN_FILTER, 1},
    Parameter{GL_TEXTURE_MAG_FILTER, 1},
    Parameter{GL_TEXTURE_WRAP_S, 1},
    Parameter{GL_TEXTURE_WRAP_T, 1},
    Parameter{GL_TEXTURE_WRAP_R, 1},
    Parameter{GL_TEXTURE_BORDER_COLOR, 4, true},
    Parameter{GL_TEXTURE_PRIORITY, 1, true},
    Parameter{GL_TEXTURE_MIN_LOD, 1},
    Parameter{GL_TEXTURE_MAX_LOD, 1},
    Parameter{GL_TEXTURE_BASE_LEVEL, 1},
    Parameter{GL_TEXTURE_MAX_LEVEL, 1},
    Parameter{GL_TEXTURE_LOD_BIAS, 1},
    Parameter{GL_TEXTURE_MAX_ANISOTROPY_EXT, 1},
    Parameter{GL_GENERATE_MIPMAP, 1},
    Parameter{GL_DEPTH_TEXTURE_MODE, 1},
    Parameter{GL_TEXTURE_COMPARE_MODE, 1},
    Parameter{GL_TEXTURE_COMPARE_FUNC, 1},
    Parameter{GL_TEXTURE_FILTER_FFGPU, 1},
};
constexpr Parameter Resident{GL_TEXTURE_RESIDENT, 1};

bool is_wrap(GLenum wrap, TextureTarget target) {
    switch (wrap) {
    case GL_CLAMP:
    case GL_CLAMP_TO_EDGE:
    case GL_CLAMP_TO_BORDER:
        return true;
    case GL_REPEAT:
    case GL_MIRRORED_REPEAT:
    case GL_MIRROR_CLAMP_EXT:
    case GL_MIRROR_CLAMP_TO_EDGE_EXT:
    case GL_MIRROR_CLAMP_TO_BORDER_EXT:
        return target != TextureTarget::Rectangle;
    default:
        return false;
    }
}

bool is_min_filter(GLenum filter, TextureTarget target) {
    const bool mipmap = filter >= GL_NEAREST_MIPMAP_NEAREST && filter <= GL_LINEAR_MIPMAP_LINEAR;
    return filter == GL_NEAREST || filter == GL_LINEAR ||
           (mipmap && target != TextureTarget::Rectangle);
}

GLenum set_token(GLenum& to, GLenum token, bool valid) {
    if (!valid) return GL_INVALID_ENUM;
    to = token;
    return GL_NO_ERROR;
}

GLenum set_level(GLint& to, float value, bool must_be_zero) {
    const GLint level = round_to_int(static_cast<double>(value));
    if (level < 0) return GL_INVALID_VALUE;
    if (must_be_zero && level != 0) return GL_INVALID_OPERATION;
    to = level;
    return GL_NO_ERROR;
}

GLenum set_tokens(TextureParameters& gl, TextureTarget target, GLenum name, GLenum token) {
    switch (name) {
    case GL_TEXTURE_MIN_FILTER:
        return set_token(gl.min_filter, token, is_min_filter(token, target));
    case GL_TEXTURE_MAG_FILTER:
        return set_token(gl.mag_filter, token, token == GL_NEAREST || token == GL_LINEAR);
    case GL_TEXTURE_WRAP_S:
        return set_token(gl.wrap_s, token, is_wrap(token, target));
    case GL_TEXTURE_WRAP_T:
        return set_token(gl.wrap_t, token, is_wrap(token, target));
    case GL_TEXTURE_WRAP_R:
        return set_token(gl.wrap_r, token, is_wrap(token, target));
    case GL_DEPTH_TEXTURE_MODE:
        return set_token(gl.depth_mode,
                         token,
                         token == GL_LUMINANCE || token == GL_INTENSITY || token == GL_ALPHA);
    case GL_TEXTURE_COMPARE_MODE:
        return set_token(
            gl.compare_mode, token, token == GL_NONE || token == GL_COMPARE_R_TO_TEXTURE);
    case GL_TEXTURE_FILTER_FFGPU:
        return set_token(
            gl.filter, token, token >= GL_STANDARD_FILTER_FFGPU && token <= GL_FELINE_FILTER_FFGPU);
    default: // GL_TEXTURE_COMPARE_FUNC
        return set_token(gl.compare_func, token, token >= GL_NEVER && token <= GL_ALWAYS);
    }
}

// GL_NO_ERROR, or the error and nothing set.
GLenum set_value(TextureParameters& gl, TextureTarget target, GLenum name, const Vec4& values) {
    const float value = values[0];
    const bool rectangle = target == TextureTarget::Rectangle;
    switch (name) {
    case GL_TEXTURE_BORDER_COLOR:
        for (std::size_t i = 0; i < 4; ++i)
            gl.border_color[i] = clamp_unit(values[i]);
        return GL_NO_ERROR;
    case GL_TEXTURE_PRIORITY:
        gl.priority = clamp_unit(value);
        return GL_NO_ERROR;
    case GL_TEXTURE_MIN_LOD:
        gl.min_lod = value;
        return GL_NO_ERROR;
    case GL_TEXTURE_MAX_LOD:
        gl.max_lod = value;
        return GL_NO_ERROR;
    case GL_TEXTURE_BASE_LEVEL:
        return set_level(gl.base_level, value, rectangle);
    case GL_TEXTURE_MAX_LEVEL:
        return set_level(gl.max_level, value, false);
    case GL_TEXTURE_LOD_BIAS:
        gl.lod_bias = value;
        return GL_NO_ERROR;
    case GL_TEXTURE_MAX_ANISOTROPY_EXT:
        if (!(value >= 1)) return GL_INVALID_VALUE;
        gl.max_anisotropy = value;
        return GL_NO_ERROR;
    case GL_GENERATE_MIPMAP:
        gl.generate_mipmap = value != 0;
        return GL_NO_ERROR;
    default:
        return set_tokens(gl, target, name, to_enum(value));
    }
}

// A colour has no form without v.
template <class Value>
void set_parameter(
    Context& context, GLenum target, GLenum name, const Value* params, bool is_vector = true) {
    const auto wanted = find_texture_target(target);
    if (!wanted) return context.error(GL_INVALID_ENUM);
    const Parameter* const parameter = find_parameter(Parameters, name);
    if (!parameter || (parameter->count > 1 && !is_vector)) return context.error(GL_INVALID_ENUM);
    TextureObject& texture =
        *context.state.texture.active().bound[static_cast<std::size_t>(*wanted)];
    TextureParameters changed = texture.parameters;
    if (const GLenum error = set_value(changed, *wanted, name, read_values(*parameter, params)))
        return context.error(error);
    if (changed == texture.parameters) return;
    texture.parameters = changed;
    texture.changed();
    mark_textures(context);
}

Vec4 get_value(const TextureParameters& gl, GLenum name) {
    const auto number = [](auto value) { return Vec4{static_cast<float>(value)}; };
    switch (name) {
    case GL_TEXTURE_MIN_FILTER:
        return number(gl.min_filter);
    case GL_TEXTURE_MAG_FILTER:
        return number(gl.mag_filter);
    case GL_TEXTURE_WRAP_S:
        return number(gl.wrap_s);
    case GL_TEXTURE_WRAP_T:
        return number(gl.wrap_t);
    case GL_TEXTURE_WRAP_R:
        return number(gl.wrap_r);
    case GL_TEXTURE_BORDER_COLOR:
        return gl.border_color;
    case GL_TEXTURE_PRIORITY:
        return number(gl.priority);
    case GL_TEXTURE_MIN_LOD:
        return number(gl.min_lod);
    case GL_TEXTURE_MAX_LOD:
        return number(gl.max_lod);
    case GL_TEXTURE_BASE_LEVEL:
        return number(gl.base_level);
    case GL_TEXTURE_MAX_LEVEL:
        return number(gl.max_level);
    case GL_TEXTURE_LOD_BIAS:
        return number(gl.lod_bias);
    case GL_TEXTURE_MAX_ANISOTROPY_EXT:
        return number(gl.max_anisotropy);
    case GL_GENERATE_MIPMAP:
        return number(gl.generate_mipmap);
    case GL_DEPTH_TEXTURE_MODE:
        return number(gl.depth_mode);
    case GL_TEXTURE_COMPARE_MODE:
        return number(gl.compare_mode);
    case GL_TEXTURE_COMPARE_FUNC:
        return number(gl.compare_func);
    case GL_TEXTURE_FILTER_FFGPU:
        return number(gl.filter);
    default:
        return number(1); // GL_TEXTURE_RESIDENT
    }
}

template <class Value>
void get_parameter(Context& context, GLenum target, GLenum name, Value* params) {
    const auto wanted = find_texture_target(target);
    const Parameter* const parameter =
        name == GL_TEXTURE_RESIDENT ? &Resident : find_parameter(Parameters, name);
    if (!wanted || !parameter) return context.error(GL_INVALID_ENUM);
    const TextureObject& texture =
        *context.state.texture.active().bound[static_cast<std::size_t>(*wanted)];
    write_values(*parameter, get_value(texture.parameters, name), params);
}

} // namespace

void TexParameterf(Context& context, GLenum target, GLenum pname, GLfloat param) {
    set_parameter(context, target, pname, Scalar(param).values, false);
}

void TexParameteri(Context& context, GLenum target, GLenum pname, GLint param) {
    set_parameter(context, target, pname, Scalar(param).values, false);
}

void TexParameterfv(Context& context, GLenum target, GLenum pname, const GLfloat* params) {
    set_parameter(context, target, pname, params);
}

void TexParameteriv(Context& context, GLenum target, GLenum pname, const GLint* params) {
    set_parameter(context, target, pname, params);
}

void GetTexParameterfv(Context& context, GLenum target, GLenum pname, GLfloat* params) {
    get_parameter(context, target, pname, params);
}

void GetTexParameteriv(Context& context, GLenum target, GLenum pname, GLint* params) {
    get_parameter(context, target, pname, params);
}

} // namespace ffgpu::gl::api
