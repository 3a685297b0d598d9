#include "model/work/target_access.h"

#include <initializer_list>

namespace ffgpu::work {
namespace {

bool tells(Compare compare) {
    return compare != Compare::Always && compare != Compare::Never;
}

// --- Stencil -------------------------------------------------------------------------------------

bool depends_on_value(StencilOp op) {
    switch (op) {
    case StencilOp::Increment:
    case StencilOp::Decrement:
    case StencilOp::Invert:
    case StencilOp::IncrementWrap:
    case StencilOp::DecrementWrap:
        return true;
    default:
        return false;
    }
}

bool tests_value(const StencilFace& face) {
    if (tells(face.compare) && face.compare_mask != 0) return true;
    if (face.write_mask == 0) return false;
    for (const StencilOp op : {face.fail, face.depth_fail, face.depth_pass})
        if (depends_on_value(op)) return true;
    return false;
}

// Of an outcome, with the operation of each face: which a primitive shows is not known here.
PixelBytes stencil_bytes(const Stencil& stencil, Format format, StencilOp StencilFace::*operation) {
    const auto bits = [operation](const StencilFace& face) -> unsigned {
        return face.*operation == StencilOp::Keep ? 0u : face.write_mask;
    };
    const ClearCommand all{.stencil = true};
    const unsigned front = bits(stencil.front), back = bits(stencil.back);
    return {cleared_depth_bytes(format, all, front | back).touched,
            cleared_depth_bytes(format, all, front & back).covered};
}

// --- Colour --------------------------------------------------------------------------------------

// Of what blending makes of a channel.
bool depends_on_destination(BlendEquation equation, BlendFactor source, BlendFactor destination) {
    if (equation == BlendEquation::Min || equation == BlendEquation::Max) return true;
    if (destination != BlendFactor::Zero) return true;
    switch (source) {
    case BlendFactor::DestinationColor:
    case BlendFactor::OneMinusDestinationColor:
    case BlendFactor::DestinationAlpha:
    case BlendFactor::OneMinusDestinationAlpha:
    case BlendFactor::SourceAlphaSaturate:
        return true;
    default:
        return false;
    }
}

bool depends_on_destination(LogicOp op) {
    return op != LogicOp::Clear && op != LogicOp::Copy && op != LogicOp::CopyInverted &&
           op != LogicOp::Set;
}

} // namespace

DepthAccess depth_access(const Registers& state) {
    const Format format = state.targets.depth.format;
    DepthAccess access;
    if (format == Format::None) return access;
    const DepthControl& depth = state.depth;
    access.tests_depth = depth.bounds_enable || (depth.test_enable && tells(depth.compare));
    if (depth.test_enable && depth.write_enable && depth.compare != Compare::Never)
        access.depth = cleared_depth_bytes(format, {.depth = true}, 0);
    const Stencil& stencil = state.stencil;
    if (!stencil.enable || format != Format::Depth24Stencil8) return access;
    access.tests_stencil = tests_value(stencil.front) || tests_value(stencil.back);
    access.passed = stencil_bytes(stencil, format, &StencilFace::depth_pass);
    access.depth_failed = stencil_bytes(stencil, format, &StencilFace::depth_fail);
    access.stencil_failed = stencil_bytes(stencil, format, &StencilFace::fail);
    return access;
}

ColorAccess color_access(const Registers& state, unsigned target) {
    const Blend& blend = state.blend;
    const Format format = state.targets.color[target].format;
    ColorAccess access;
    if (format == Format::None) return access;
    access.written = written_color_bytes(format, blend.write_mask);
    if (access.written.touched == 0) return access;
    if (blend.logic_op_enable) { // Of sRGB codes it is blending that goes on.
        access.reads = depends_on_destination(blend.logic_op) || state.fragment.is_srgb(target);
    } else if (blend.enable) {
        constexpr unsigned Colors = 7, Alpha = 8;
        const bool colors =
            depends_on_destination(blend.rgb_equation, blend.rgb_source, blend.rgb_destination);
        const bool alpha = depends_on_destination(
            blend.alpha_equation, blend.alpha_source, blend.alpha_destination);
        access.reads = (colors && (blend.write_mask & Colors) != 0) ||
                       (alpha && (blend.write_mask & Alpha) != 0);
    }
    return access;
}

} // namespace ffgpu::work
