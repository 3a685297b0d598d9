// Lights and the light model (GL 1.5, 2.14.1 and 2.14.2), shade model (2.14.7).

#include "driver/api/parameters.h"
#include "driver/commands/declarations.h"
#include "driver/context/context.h"
#include "driver/math/matrix.h"

#include <algorithm>

namespace ffgpu::gl::api {
namespace {

constexpr Parameter LightParameters[] = {
    {GL_AMBIENT, 4, true},
    {GL_DIFFUSE, 4, true},
    {GL_SPECULAR, 4, true},
    {GL_POSITION, 4},
    {GL_SPOT_DIRECTION, 3},
    {GL_SPOT_EXPONENT, 1},
    {GL_SPOT_CUTOFF, 1},
    {GL_CONSTANT_ATTENUATION, 1},
    {GL_LINEAR_ATTENUATION, 1},
    {GL_QUADRATIC_ATTENUATION, 1},
};

constexpr Parameter LightModelParameters[] = {
    {GL_LIGHT_MODEL_AMBIENT, 4, true},
    {GL_LIGHT_MODEL_LOCAL_VIEWER, 1},
    {GL_LIGHT_MODEL_TWO_SIDE, 1},
    {GL_LIGHT_MODEL_COLOR_CONTROL, 1},
};

LightSource* find_light(Context& context, GLenum light) {
    if (light < GL_LIGHT0 || light >= GL_LIGHT0 + Lights) return nullptr;
    return &context.state.lighting.lights[light - GL_LIGHT0];
}

// By the model-view matrix's upper left 3x3 as it is now.
std::array<float, 3> transform_direction(const Mat4& m, const Vec4& direction) {
    const Vec4 eye = transform(m, {direction[0], direction[1], direction[2], 0});
    return {eye[0], eye[1], eye[2]};
}

bool is_legal(GLenum name, float value) {
    switch (name) {
    case GL_SPOT_EXPONENT:
        return value >= 0 && value <= 128;
    case GL_SPOT_CUTOFF:
        return (value >= 0 && value <= 90) || value == 180;
    case GL_CONSTANT_ATTENUATION:
    case GL_LINEAR_ATTENUATION:
    case GL_QUADRATIC_ATTENUATION:
        return value >= 0;
    default:
        return true;
    }
}

void set_light(LightSource& light, GLenum name, const Vec4& values, const Mat4& model_view) {
    switch (name) {
    case GL_AMBIENT:
        light.ambient = values;
        break;
    case GL_DIFFUSE:
        light.diffuse = values;
        break;
    case GL_SPECULAR:
        light.specular = values;
        break;
    case GL_POSITION:
        light.position = transform(model_view, values);
        break;
    case GL_SPOT_DIRECTION:
        light.spot_direction = transform_direction(model_view, values);
        break;
    case GL_SPOT_EXPONENT:
        light.spot_exponent = values[0];
        break;
    case GL_SPOT_CUTOFF:
        light.spot_cutoff = values[0];
        break;
    default:
        light.attenuation[name - GL_CONSTANT_ATTENUATION] = values[0];
    }
}

Vec4 light_values(const LightSource& light, GLenum name) {
    switch (name) {
    case GL_AMBIENT:
        return light.ambient;
    case GL_DIFFUSE:
        return light.diffuse;
    case GL_SPECULAR:
        return light.specular;
    case GL_POSITION:
        return light.position;
    case GL_SPOT_DIRECTION:
        return {light.spot_direction[0], light.spot_direction[1], light.spot_direction[2], 0};
    case GL_SPOT_EXPONENT:
        return {light.spot_exponent};
    case GL_SPOT_CUTOFF:
        return {light.spot_cutoff};
    default:
        return {light.attenuation[name - GL_CONSTANT_ATTENUATION]};
    }
}

template <class Number>
void set_light(Context& context, GLenum number, GLenum name, const Number* params) {
    LightSource* const light = find_light(context, number);
    const Parameter* const parameter = find_parameter(LightParameters, name);
    if (!light || !parameter) return context.error(GL_INVALID_ENUM);
    const Vec4 values = read_values(*parameter, params);
    if (!is_legal(name, values[0])) return context.error(GL_INVALID_VALUE);
    set_light(*light, name, values, context.state.transform.matrices.model_view.top());
    context.dirty.mark(Dirty::Lighting);
}

template <class Number>
void get_light(Context& context, GLenum number, GLenum name, Number* params) {
    const LightSource* const light = find_light(context, number);
    const Parameter* const parameter = find_parameter(LightParameters, name);
    if (!light || !parameter) return context.error(GL_INVALID_ENUM);
    write_values(*parameter, light_values(*light, name), params);
}

template <class Number>
void set_light_model(Context& context, GLenum name, const Number* params) {
    const Parameter* const parameter = find_parameter(LightModelParameters, name);
    if (!parameter) return context.error(GL_INVALID_ENUM);
    const Vec4 values = read_values(*parameter, params);
    LightModel& model = context.state.lighting.model;
    switch (name) {
    case GL_LIGHT_MODEL_AMBIENT:
        model.ambient = values;
        break;
    case GL_LIGHT_MODEL_LOCAL_VIEWER:
        model.local_viewer = values[0] != 0;
        break;
    case GL_LIGHT_MODEL_TWO_SIDE:
        model.two_side = values[0] != 0;
        break;
    default: {
        const GLenum control = to_enum(values[0]);
        if (control != GL_SINGLE_COLOR && control != GL_SEPARATE_SPECULAR_COLOR)
            return context.error(GL_INVALID_ENUM);
        model.color_control = control;
        context.dirty.mark(Dirty::Fragment); // the colour sum
    }
    }
    context.dirty.mark(Dirty::Lighting);
}

} // namespace

void Lightf(Context& context, GLenum light, GLenum pname, GLfloat param) {
    set_light(context, light, pname, Scalar(param).values);
}

void Lighti(Context& context, GLenum light, GLenum pname, GLint param) {
    set_light(context, light, pname, Scalar(param).values);
}

void Lightfv(Context& context, GLenum light, GLenum pname, const GLfloat* params) {
    set_light(context, light, pname, params);
}

void Lightiv(Context& context, GLenum light, GLenum pname, const GLint* params) {
    set_light(context, light, pname, params);
}

void GetLightfv(Context& context, GLenum light, GLenum pname, GLfloat* params) {
    get_light(context, light, pname, params);
}

void GetLightiv(Context& context, GLenum light, GLenum pname, GLint* params) {
    get_light(context, light, pname, params);
}

void LightModelf(Context& context, GLenum pname, GLfloat param) {
    set_light_model(context, pname, Scalar(param).values);
}

void LightModeli(Context& context, GLenum pname, GLint param) {
    set_light_model(context, pname, Scalar(param).values);
}

void LightModelfv(Context& context, GLenum pname, const GLfloat* params) {
    set_light_model(context, pname, params);
}

void LightModeliv(Context& context, GLenum pname, const GLint* params) {
    set_light_model(context, pname, params);
}

void ShadeModel(Context& context, GLenum mode) {
    if (mode != GL_FLAT && mode != GL_SMOOTH) return context.error(GL_INVALID_ENUM);
    context.state.lighting.shade_model = mode;
    context.dirty.mark(Dirty::Primitive);
}

} // namespace ffgpu::gl::api
