// Blending and logical operations (GL 1.5, 4.1.8 and 4.1.10).

#include "driver/commands/declarations.h"
#include "driver/context/context.h"
#include "driver/math/conversion.h"

namespace ffgpu::gl::api {
namespace {

bool is_destination_factor(GLenum factor) {
    switch (factor) {
    case GL_ZERO:
    case GL_ONE:
    case GL_SRC_COLOR:
    case GL_ONE_MINUS_SRC_COLOR:
    case GL_DST_COLOR:
    case GL_ONE_MINUS_DST_COLOR:
    case GL_SRC_ALPHA:
    case GL_ONE_MINUS_SRC_ALPHA:
    case GL_DST_ALPHA:
    case GL_ONE_MINUS_DST_ALPHA:
    case GL_CONSTANT_COLOR:
    case GL_ONE_MINUS_CONSTANT_COLOR:
    case GL_CONSTANT_ALPHA:
    case GL_ONE_MINUS_CONSTANT_ALPHA:
        return true;
    default:
        return false;
    }
}

bool is_source_factor(GLenum factor) {
    return factor == GL_SRC_ALPHA_SATURATE || is_destination_factor(factor);
}

bool is_equation(GLenum mode) {
    return mode == GL_FUNC_ADD || mode == GL_FUNC_SUBTRACT || mode == GL_FUNC_REVERSE_SUBTRACT ||
           mode == GL_MIN || mode == GL_MAX;
}

} // namespace

void BlendFuncSeparate(Context& context,
                       GLenum sfactorRGB,
                       GLenum dfactorRGB,
                       GLenum sfactorAlpha,
                       GLenum dfactorAlpha) {
    if (!is_source_factor(sfactorRGB) || !is_source_factor(sfactorAlpha))
        return context.error(GL_INVALID_ENUM);
    if (!is_destination_factor(dfactorRGB) || !is_destination_factor(dfactorAlpha))
        return context.error(GL_INVALID_ENUM);
    BlendState& blend = context.state.fragment.blend;
    blend.rgb_source = sfactorRGB;
    blend.rgb_destination = dfactorRGB;
    blend.alpha_source = sfactorAlpha;
    blend.alpha_destination = dfactorAlpha;
    context.dirty.mark(Dirty::Fragment);
}

void BlendFunc(Context& context, GLenum sfactor, GLenum dfactor) {
    BlendFuncSeparate(context, sfactor, dfactor, sfactor, dfactor);
}

void BlendEquationSeparateEXT(Context& context, GLenum modeRGB, GLenum modeAlpha) {
    if (!is_equation(modeRGB) || !is_equation(modeAlpha)) return context.error(GL_INVALID_ENUM);
    BlendState& blend = context.state.fragment.blend;
    blend.rgb_equation = modeRGB;
    blend.alpha_equation = modeAlpha;
    context.dirty.mark(Dirty::Fragment);
}

void BlendEquation(Context& context, GLenum mode) {
    BlendEquationSeparateEXT(context, mode, mode);
}

void BlendColor(Context& context, GLfloat red, GLfloat green, GLfloat blue, GLfloat alpha) {
    context.state.fragment.blend.color = {
        clamp_unit(red), clamp_unit(green), clamp_unit(blue), clamp_unit(alpha)};
    context.dirty.mark(Dirty::Fragment);
}

void LogicOp(Context& context, GLenum opcode) {
    if (opcode < GL_CLEAR || opcode > GL_SET) return context.error(GL_INVALID_ENUM);
    context.state.fragment.blend.logic_op = opcode;
    context.dirty.mark(Dirty::Fragment);
}

} // namespace ffgpu::gl::api
