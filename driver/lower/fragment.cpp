#include "driver/lower/fragment.h"

#include "driver/math/conversion.h"
#include "driver/pixel/rgba8.h"
#include "model/device/layout/limits.h"

#include <algorithm>

namespace ffgpu::gl {
namespace {

Compare lower_compare(GLenum func) {
    return static_cast<Compare>(func - GL_NEVER);
}
static_assert(GL_ALWAYS - GL_NEVER == static_cast<GLenum>(Compare::Always));

FogMode lower_fog_mode(GLenum mode) {
    switch (mode) {
    case GL_LINEAR:
        return FogMode::Linear;
    case GL_EXP:
        return FogMode::Exp;
    default:
        return FogMode::Exp2;
    }
}

FogCoordinateSource lower_fog_source(const FogState& gl) {
    if (gl.coordinate_source == GL_FOG_COORD) return FogCoordinateSource::Attribute;
    switch (gl.distance_mode) {
    case GL_EYE_PLANE:
        return FogCoordinateSource::EyeZSigned;
    case GL_EYE_RADIAL_NV:
        return FogCoordinateSource::EyeRadial;
    default:
        return FogCoordinateSource::EyeZ;
    }
}

StencilOp lower_operation(GLenum operation) {
    switch (operation) {
    case GL_ZERO:
        return StencilOp::Zero;
    case GL_REPLACE:
        return StencilOp::Replace;
    case GL_INCR:
        return StencilOp::Increment;
    case GL_DECR:
        return StencilOp::Decrement;
    case GL_INVERT:
        return StencilOp::Invert;
    case GL_INCR_WRAP:
        return StencilOp::IncrementWrap;
    case GL_DECR_WRAP:
        return StencilOp::DecrementWrap;
    default:
        return StencilOp::Keep;
    }
}

StencilFace lower_face(const StencilFaceState& gl) {
    return {.compare = lower_compare(gl.func),
            .fail = lower_operation(gl.fail),
            .depth_fail = lower_operation(gl.depth_fail),
            .depth_pass = lower_operation(gl.depth_pass),
            .reference = static_cast<std::uint8_t>(std::clamp(gl.reference, 0, 255)),
            .compare_mask = static_cast<std::uint8_t>(gl.compare_mask),
            .write_mask = static_cast<std::uint8_t>(gl.write_mask)};
}

BlendFactor lower_factor(GLenum factor) {
    switch (factor) {
    case GL_ZERO:
        return BlendFactor::Zero;
    case GL_SRC_COLOR:
        return BlendFactor::SourceColor;
    case GL_ONE_MINUS_SRC_COLOR:
        return BlendFactor::OneMinusSourceColor;
    case GL_DST_COLOR:
        return BlendFactor::DestinationColor;
    case GL_ONE_MINUS_DST_COLOR:
        return BlendFactor::OneMinusDestinationColor;
    case GL_SRC_ALPHA:
        return BlendFactor::SourceAlpha;
    case GL_ONE_MINUS_SRC_ALPHA:
        return BlendFactor::OneMinusSourceAlpha;
    case GL_DST_ALPHA:
        return BlendFactor::DestinationAlpha;
    case GL_ONE_MINUS_DST_ALPHA:
        return BlendFactor::OneMinusDestinationAlpha;
    case GL_CONSTANT_COLOR:
        return BlendFactor::ConstantColor;
    case GL_ONE_MINUS_CONSTANT_COLOR:
        return BlendFactor::OneMinusConstantColor;
    case GL_CONSTANT_ALPHA:
        return BlendFactor::ConstantAlpha;
    case GL_ONE_MINUS_CONSTANT_ALPHA:
        return BlendFactor::OneMinusConstantAlpha;
    case GL_SRC_ALPHA_SATURATE:
        return BlendFactor::SourceAlphaSaturate;
    default:
        return BlendFactor::One;
    }
}

BlendEquation lower_equation(GLenum equation) {
    switch (equation) {
    case GL_FUNC_SUBTRACT:
        return BlendEquation::Subtract;
    case GL_FUNC_REVERSE_SUBTRACT:
        return BlendEquation::ReverseSubtract;
    case GL_MIN:
        return BlendEquation::Min;
    case GL_MAX:
        return BlendEquation::Max;
    default:
        return BlendEquation::Add;
    }
}

constexpr unsigned AllSamples = (1u << MaxSamples) - 1;

} // namespace

Fog lower_fog(const FogState& gl) {
    if (!gl.enable) return {};
    return {.mode = lower_fog_mode(gl.mode),
            .source = lower_fog_source(gl),
            .color = pack_rgba8(gl.color) & 0xffffff,
            .density = gl.density,
            .start = gl.start,
            .end = gl.end};
}

FragmentControl lower_fragment_control(const FragmentState& gl,
                                       const LightingState& lighting,
                                       bool query_is_active,
                                       std::uint8_t srgb_capable) {
    // GL 1.5, 3.9: with lighting on, GL_COLOR_SUM does not matter; the secondary colour is that of
    // the light model's colour control, black if it is single.
    const bool lit_secondary = lighting.model.color_control == GL_SEPARATE_SPECULAR_COLOR;
    return {.color_sum = lighting.enable ? lit_secondary : gl.fog.color_sum,
            .alpha_test = gl.alpha_test.enable,
            .alpha_compare = lower_compare(gl.alpha_test.func),
            .alpha_reference =
                static_cast<std::uint8_t>(unorm(static_cast<double>(gl.alpha_test.reference), 8)),
            .dither = gl.blend.dither,
            .count_samples = query_is_active,
            .srgb_targets = gl.blend.framebuffer_srgb ? srgb_capable : std::uint8_t{0}};
}

Stencil lower_stencil(const StencilState& gl, DepthTarget target) {
    // EXT_stencil_two_side's back face comes before ATI_separate_stencil's, which without the use
    // of its commands equals the front face.
    return {.enable = gl.enable && target.stencil_bits > 0,
            .front = lower_face(gl.front),
            .back = lower_face(gl.two_side ? gl.two_side_back : gl.back)};
}

DepthControl lower_depth(const DepthState& gl, DepthTarget target) {
    const bool exists = target.depth_bits > 0;
    return {.test_enable = gl.enable && exists,
            // GL 1.5, 4.1.6: without the test the buffer is not written either.
            .write_enable = gl.enable && gl.write_mask && exists,
            .compare = lower_compare(gl.func),
            .bounds_enable = gl.bounds_test && exists,
            .bounds_min = unorm(gl.bounds_min, target.depth_bits),
            .bounds_max = unorm(gl.bounds_max, target.depth_bits)};
}

// GL 1.5, 4.1.3: a value v lets round(4 v) of the samples through, the first ones; inverted, the
// others. Without GL_MULTISAMPLE nothing of it has an effect.
Multisample lower_multisample(const MultisampleState& gl) {
    if (!gl.enable) return {};
    unsigned mask = AllSamples;
    if (gl.sample_coverage) {
        const auto count = static_cast<unsigned>(gl.coverage_value * float{MaxSamples} + 0.5f);
        mask = (1u << count) - 1;
        if (gl.coverage_invert) mask ^= AllSamples;
    }
    return {.enable = true,
            .alpha_to_coverage = gl.alpha_to_coverage,
            .alpha_to_one = gl.alpha_to_one,
            .sample_mask = static_cast<std::uint8_t>(mask)};
}

Blend lower_blend(const BlendState& gl, const std::array<bool, 4>& color_mask) {
    std::uint8_t mask = 0;
    for (unsigned i = 0; i < 4; ++i)
        mask = static_cast<std::uint8_t>(mask | (color_mask[i] ? 1u << i : 0u));
    return {.enable = gl.enable && !gl.color_logic_op, // GL 1.5, 4.1.10
            .logic_op_enable = gl.color_logic_op,
            .logic_op = static_cast<LogicOp>(gl.logic_op - GL_CLEAR),
            .rgb_equation = lower_equation(gl.rgb_equation),
            .alpha_equation = lower_equation(gl.alpha_equation),
            .rgb_source = lower_factor(gl.rgb_source),
            .rgb_destination = lower_factor(gl.rgb_destination),
            .alpha_source = lower_factor(gl.alpha_source),
            .alpha_destination = lower_factor(gl.alpha_destination),
            .constant = pack_rgba8(gl.color),
            .write_mask = mask};
}
static_assert(GL_SET - GL_CLEAR == static_cast<GLenum>(LogicOp::Set));

} // namespace ffgpu::gl
