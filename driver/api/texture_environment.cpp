// glTexEnv and glGetTexEnv (GL 1.5, 3.8.13; EXT_texture_lod_bias, ARB_point_sprite,
// ATI_texture_env_combine3, NV_texture_env_combine4).

#include "driver/api/parameters.h"
#include "driver/commands/declarations.h"
#include "driver/context/context.h"

#include <algorithm>
#include <array>

namespace ffgpu::gl::api {
namespace {

constexpr std::array EnvironmentParameters{
    Parameter{GL_TEXTURE_ENV_MODE, 1}, Parameter{GL_TEXTURE_ENV_COLOR, 4, true},
    Parameter{GL_COMBINE_RGB, 1},      Parameter{GL_COMBINE_ALPHA, 1},
    Parameter{GL_SRC0_RGB, 1},         Parameter{GL_SRC1_RGB, 1},
    Parameter{GL_SRC2_RGB, 1},         Parameter{GL_SOURCE3_RGB_NV, 1},
    Parameter{GL_SRC0_ALPHA, 1},       Parameter{GL_SRC1_ALPHA, 1},
    Parameter{GL_SRC2_ALPHA, 1},       Parameter{GL_SOURCE3_ALPHA_NV, 1},
    Parameter{GL_OPERAND0_RGB, 1},     Parameter{GL_OPERAND1_RGB, 1},
    Parameter{GL_OPERAND2_RGB, 1},     Parameter{GL_OPERAND3_RGB_NV, 1},
    Parameter{GL_OPERAND0_ALPHA, 1},   Parameter{GL_OPERAND1_ALPHA, 1},
    Parameter{GL_OPERAND2_ALPHA, 1},   Parameter{GL_OPERAND3_ALPHA_NV, 1},
    Parameter{GL_RGB_SCALE, 1},        Parameter{GL_ALPHA_SCALE, 1},
};
constexpr std::array FilterParameters{Parameter{GL_TEXTURE_LOD_BIAS, 1}};
constexpr std::array PointParameters{Parameter{GL_COORD_REPLACE, 1}};

const Parameter* find_environment_parameter(GLenum target, GLenum name) {
    switch (target) {
    case GL_TEXTURE_ENV:
        return find_parameter(EnvironmentParameters, name);
    case GL_TEXTURE_FILTER_CONTROL:
        return find_parameter(FilterParameters, name);
    case GL_POINT_SPRITE:
        return find_parameter(PointParameters, name);
    default:
        return nullptr;
    }
}

bool is_mode(GLenum mode) {
    switch (mode) {
    case GL_MODULATE:
    case GL_DECAL:
    case GL_BLEND:
    case GL_REPLACE:
    case GL_ADD:
    case GL_COMBINE:
    case GL_COMBINE4_NV:
        return true;
    default:
        return false;
    }
}

bool is_dot_product(GLenum function) {
    return function == GL_DOT3_RGB || function == GL_DOT3_RGBA || function == GL_DOT3_RGB_EXT ||
           function == GL_DOT3_RGBA_EXT;
}

bool is_function(GLenum function) {
    switch (function) {
    case GL_REPLACE:
    case GL_MODULATE:
    case GL_ADD:
    case GL_ADD_SIGNED:
    case GL_INTERPOLATE:
    case GL_SUBTRACT:
    case GL_MODULATE_ADD_ATI:
    case GL_MODULATE_SIGNED_ADD_ATI:
    case GL_MODULATE_SUBTRACT_ATI:
        return true;
    default:
        return false;
    }
}

bool is_source(GLenum source) {
    switch (source) {
    case GL_TEXTURE:
    case GL_CONSTANT:
    case GL_PRIMARY_COLOR:
    case GL_PREVIOUS:
    case GL_ZERO:
    case GL_ONE:
        return true;
    default:
        return source >= GL_TEXTURE0 && source < GL_TEXTURE0 + TextureUnits;
    }
}

bool is_alpha_operand(GLenum operand) {
    return operand == GL_SRC_ALPHA || operand == GL_ONE_MINUS_SRC_ALPHA;
}

bool is_color_operand(GLenum operand) {
    return operand == GL_SRC_COLOR || operand == GL_ONE_MINUS_SRC_COLOR ||
           is_alpha_operand(operand);
}

// The token that a parameter names in an environment; null: it is not a token.
template <class Environment>
auto* find_token(Environment& gl, GLenum name) {
    const auto among = [name](GLenum first) { return name >= first && name < first + 4; };
    if (among(GL_SRC0_RGB)) return &gl.source_rgb[name - GL_SRC0_RGB];
    if (among(GL_SRC0_ALPHA)) return &gl.source_alpha[name - GL_SRC0_ALPHA];
    if (among(GL_OPERAND0_RGB)) return &gl.operand_rgb[name - GL_OPERAND0_RGB];
    if (among(GL_OPERAND0_ALPHA)) return &gl.operand_alpha[name - GL_OPERAND0_ALPHA];
    switch (name) {
    case GL_TEXTURE_ENV_MODE:
        return &gl.mode;
    case GL_COMBINE_RGB:
        return &gl.combine_rgb;
    case GL_COMBINE_ALPHA:
        return &gl.combine_alpha;
    default:
        return static_cast<decltype(&gl.mode)>(nullptr);
    }
}

bool is_token_of(GLenum name, GLenum token) {
    const auto among = [name](GLenum first) { return name >= first && name < first + 4; };
    if (among(GL_SRC0_RGB) || among(GL_SRC0_ALPHA)) return is_source(token);
    if (among(GL_OPERAND0_RGB)) return is_color_operand(token);
    if (among(GL_OPERAND0_ALPHA)) return is_alpha_operand(token);
    if (name == GL_TEXTURE_ENV_MODE) return is_mode(token);
    return is_function(token) || (name == GL_COMBINE_RGB && is_dot_product(token));
}

GLenum set_scale(float& to, float value) {
    if (value != 1 && value != 2 && value != 4) return GL_INVALID_VALUE;
    to = value;
    return GL_NO_ERROR;
}

// GL_NO_ERROR, or the error and nothing set.
GLenum set_value(TextureEnvironment& gl, GLenum name, const Vec4& values) {
    switch (name) {
    case GL_TEXTURE_ENV_COLOR:
        for (std::size_t i = 0; i < 4; ++i)
            gl.color[i] = clamp_unit(values[i]);
        return GL_NO_ERROR;
    case GL_RGB_SCALE:
        return set_scale(gl.rgb_scale, values[0]);
    case GL_ALPHA_SCALE:
        return set_scale(gl.alpha_scale, values[0]);
    case GL_TEXTURE_LOD_BIAS:
        gl.lod_bias = values[0];
        return GL_NO_ERROR;
    case GL_COORD_REPLACE: {
        if (values[0] != 0 && values[0] != 1) return GL_INVALID_VALUE;
        gl.coord_replace = values[0] != 0;
        return GL_NO_ERROR;
    }
    default:
        break;
    }
    const GLenum token = to_enum(values[0]);
    if (!is_token_of(name, token)) return GL_INVALID_ENUM;
    *find_token(gl, name) = token;
    return GL_NO_ERROR;
}

template <class Value>
void set_environment(
    Context& context, GLenum target, GLenum name, const Value* params, bool is_vector) {
    const Parameter* const parameter = find_environment_parameter(target, name);
    if (!parameter || (parameter->count > 1 && !is_vector)) return context.error(GL_INVALID_ENUM);
    TextureEnvironment& environment = context.state.texture.active().environment;
    if (const GLenum error = set_value(environment, name, read_values(*parameter, params)))
        return context.error(error);
    context.dirty.mark(Dirty::Environments);
}

Vec4 get_value(const TextureEnvironment& gl, GLenum name) {
    const auto number = [](auto value) { return Vec4{static_cast<float>(value)}; };
    switch (name) {
    case GL_TEXTURE_ENV_COLOR:
        return gl.color;
    case GL_RGB_SCALE:
        return number(gl.rgb_scale);
    case GL_ALPHA_SCALE:
        return number(gl.alpha_scale);
    case GL_TEXTURE_LOD_BIAS:
        return number(gl.lod_bias);
    case GL_COORD_REPLACE:
        return number(gl.coord_replace);
    default:
        return number(*find_token(gl, name));
    }
}

template <class Value>
void get_environment(Context& context, GLenum target, GLenum name, Value* params) {
    const Parameter* const parameter = find_environment_parameter(target, name);
    if (!parameter) return context.error(GL_INVALID_ENUM);
    const TextureEnvironment& environment = context.state.texture.active().environment;
    write_values(*parameter, get_value(environment, name), params);
}

} // namespace

void TexEnvf(Context& context, GLenum target, GLenum pname, GLfloat param) {
    set_environment(context, target, pname, &param, false);
}

void TexEnvi(Context& context, GLenum target, GLenum pname, GLint param) {
    set_environment(context, target, pname, &param, false);
}

void TexEnvfv(Context& context, GLenum target, GLenum pname, const GLfloat* params) {
    set_environment(context, target, pname, params, true);
}

void TexEnviv(Context& context, GLenum target, GLenum pname, const GLint* params) {
    set_environment(context, target, pname, params, true);
}

void GetTexEnvfv(Context& context, GLenum target, GLenum pname, GLfloat* params) {
    get_environment(context, target, pname, params);
}

void GetTexEnviv(Context& context, GLenum target, GLenum pname, GLint* params) {
    get_environment(context, target, pname, params);
}

} // namespace ffgpu::gl::api
