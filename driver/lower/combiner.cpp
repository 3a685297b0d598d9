#include "driver/lower/combiner.h"

#include "driver/pixel/rgba8.h"

namespace ffgpu::gl {

namespace {

using enum CombineOperand;

constexpr CombineArgument PreviousColor{CombineSource::Previous, Color};
constexpr CombineArgument PreviousAlpha{CombineSource::Previous, Alpha};
constexpr CombineArgument ConstantColor{CombineSource::Constant, Color};
constexpr CombineArgument ConstantAlpha{CombineSource::Constant, Alpha};

constexpr CombineSource texture_source(unsigned unit) {
    return static_cast<CombineSource>(static_cast<unsigned>(CombineSource::Texture0) + unit);
}

template <class... Arguments>
constexpr CombineHalf half(CombineOp op, Arguments... arguments) {
    return {op, {arguments...}, 0};
}

bool has_color(BaseFormat format) {
    return format != BaseFormat::Alpha;
}

bool has_alpha(BaseFormat format) {
    return format != BaseFormat::Luminance && format != BaseFormat::Rgb;
}

// The five modes of OpenGL 1.0 to 1.3 (tables 3.22 and 3.23). A component that the texture's format
// lacks passes unchanged; the alpha of all but replacement and blended intensity is a product.
Combiner lower_fixed_mode(GLenum mode, unsigned unit, BaseFormat format) {
    const CombineArgument color{texture_source(unit), Color};
    const CombineArgument alpha{texture_source(unit), Alpha};
    const bool intensity = format == BaseFormat::Intensity;

    Combiner combiner;
    combiner.rgb = half(CombineOp::Replace, PreviousColor);
    combiner.alpha = half(CombineOp::Replace, PreviousAlpha);
    if (mode == GL_DECAL) { // Defined for RGB and RGBA only.
        if (format == BaseFormat::Rgb) combiner.rgb = half(CombineOp::Replace, color);
        if (format == BaseFormat::Rgba)
            combiner.rgb = half(CombineOp::Interpolate, color, PreviousColor, alpha);
        return combiner;
    }
    if (has_alpha(format)) combiner.alpha = half(CombineOp::Modulate, PreviousAlpha, alpha);
    switch (mode) {
    case GL_REPLACE:
        if (has_color(format)) combiner.rgb = half(CombineOp::Replace, color);
        if (has_alpha(format)) combiner.alpha = half(CombineOp::Replace, alpha);
        break;
    case GL_BLEND:
        if (has_color(format))
            combiner.rgb = half(CombineOp::Interpolate, ConstantColor, PreviousColor, color);
        if (intensity)
            combiner.alpha = half(CombineOp::Interpolate, ConstantAlpha, PreviousAlpha, alpha);
        break;
    case GL_ADD:
        if (has_color(format)) combiner.rgb = half(CombineOp::Add, PreviousColor, color);
        if (intensity) combiner.alpha = half(CombineOp::Add, PreviousAlpha, alpha);
        break;
    default: // GL_MODULATE
        if (has_color(format)) combiner.rgb = half(CombineOp::Modulate, PreviousColor, color);
        break;
    }
    return combiner;
}

CombineOp lower_function(GLenum function, bool four_arguments) {
    switch (function) {
    case GL_MODULATE:
        return CombineOp::Modulate;
    case GL_ADD:
        return four_arguments ? CombineOp::AddProducts : CombineOp::Add;
    case GL_ADD_SIGNED:
        return four_arguments ? CombineOp::AddProductsSigned : CombineOp::AddSigned;
    case GL_INTERPOLATE:
        return CombineOp::Interpolate;
    case GL_SUBTRACT:
        return CombineOp::Subtract;
    case GL_DOT3_RGB:
    case GL_DOT3_RGB_EXT:
        return CombineOp::Dot3Rgb;
    case GL_DOT3_RGBA:
    case GL_DOT3_RGBA_EXT:
        return CombineOp::Dot3Rgba;
    case GL_MODULATE_ADD_ATI:
        return CombineOp::ModulateAdd;
    case GL_MODULATE_SIGNED_ADD_ATI:
        return CombineOp::ModulateSignedAdd;
    case GL_MODULATE_SUBTRACT_ATI:
        return CombineOp::ModulateSubtract;
    default:
        return CombineOp::Replace;
    }
}

CombineSource lower_source(GLenum source, unsigned unit) {
    switch (source) {
    case GL_TEXTURE:
        return texture_source(unit);
    case GL_CONSTANT:
        return CombineSource::Constant;
    case GL_PRIMARY_COLOR:
        return CombineSource::Primary;
    case GL_PREVIOUS:
        return CombineSource::Previous;
    case GL_ZERO:
        return CombineSource::Zero;
    case GL_ONE:
        return CombineSource::One;
    default:
        return texture_source(source - GL_TEXTURE0);
    }
}

CombineOperand lower_operand(GLenum operand) {
    switch (operand) {
    case GL_ONE_MINUS_SRC_COLOR:
        return OneMinusColor;
    case GL_SRC_ALPHA:
        return Alpha;
    case GL_ONE_MINUS_SRC_ALPHA:
        return OneMinusAlpha;
    default:
        return Color;
    }
}

std::uint8_t lower_scale(float scale) {
    return scale == 4.0f ? 2 : scale == 2.0f ? 1 : 0;
}

// EXT_texture_env_dot3 left its results unscaled; ARB's and the core's dot products are scaled.
bool is_unscaled(GLenum function) {
    return function == GL_DOT3_RGB_EXT || function == GL_DOT3_RGBA_EXT;
}

Combiner lower_combine(const TextureEnvironment& environment, unsigned unit) {
    const bool four = environment.mode == GL_COMBINE4_NV;
    Combiner combiner;
    combiner.rgb.op = lower_function(environment.combine_rgb, four);
    combiner.alpha.op = lower_function(environment.combine_alpha, four);
    for (unsigned i = 0; i < argument_count(combiner.rgb.op); ++i) {
        combiner.rgb.arguments[i] = {lower_source(environment.source_rgb[i], unit),
                                     lower_operand(environment.operand_rgb[i])};
    }
    for (unsigned i = 0; i < argument_count(combiner.alpha.op); ++i) {
        combiner.alpha.arguments[i] = {lower_source(environment.source_alpha[i], unit),
                                       lower_operand(environment.operand_alpha[i])};
    }
    if (!is_unscaled(environment.combine_rgb))
        combiner.rgb.scale_shift = lower_scale(environment.rgb_scale);
    if (environment.combine_rgb != GL_DOT3_RGBA_EXT) // whose alpha is the dot product
        combiner.alpha.scale_shift = lower_scale(environment.alpha_scale);
    return combiner;
}

// ARB_texture_env_crossbar: an environment that reads a unit which is off is off itself.
bool reads_off_unit(const CombineHalf& half, const SampledFormats& formats) {
    for (unsigned i = 0; i < argument_count(half.op); ++i) {
        const unsigned source = static_cast<unsigned>(half.arguments[i].source) -
                                static_cast<unsigned>(CombineSource::Texture0);
        if (source < TextureUnits && formats[source] == BaseFormat::None) return true;
    }
    return false;
}

} // namespace

Combiner lower_combiner(const TextureEnvironment& environment,
                        unsigned unit,
                        const SampledFormats& formats) {
    if (formats[unit] == BaseFormat::None) return {};
    const bool combine = environment.mode == GL_COMBINE || environment.mode == GL_COMBINE4_NV;
    Combiner combiner = combine ? lower_combine(environment, unit)
                                : lower_fixed_mode(environment.mode, unit, formats[unit]);
    if (reads_off_unit(combiner.rgb, formats) || reads_off_unit(combiner.alpha, formats)) return {};
    combiner.enable = true;
    combiner.constant = pack_rgba8(environment.color);
    return combiner;
}

} // namespace ffgpu::gl
