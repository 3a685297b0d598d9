#include "model/work/target_access.h"

#include "model/device/compare.h"

#include <array>

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

// How a fragment's stencil and depth test can end, whatever it and the target hold.
struct Ends {
    bool stencil_failed = false, depth_failed = false, passed = false;

    bool comes_to_depth() const { return depth_failed || passed; }
};

Ends possible_ends(const StencilFace* face, const DepthControl& depth) {
    bool fails = false, passes = true;
    if (face) {
        passes = false;
        for (unsigned value = 0; value < 256; ++value) {
            const bool pass = compare(
                face->compare, face->reference & face->compare_mask, value & face->compare_mask);
            (pass ? passes : fails) = true;
        }
    }
    return {.stencil_failed = fails,
            .depth_failed = passes && depth.test_enable && depth.compare != Compare::Always,
            .passed = passes && !(depth.test_enable && depth.compare == Compare::Never)};
}

bool tests_value(const StencilFace& face, const Ends& ends) {
    if (ends.stencil_failed && ends.comes_to_depth()) return true;
    if (face.write_mask == 0) return false;
    return (ends.stencil_failed && depends_on_value(face.fail)) ||
           (ends.depth_failed && depends_on_value(face.depth_fail)) ||
           (ends.passed && depends_on_value(face.depth_pass));
}

struct FaceEnds {
    const StencilFace& face;
    Ends ends;
};

// Of one end, by the operation of each face that can come to it: which a primitive shows is not
// known here.
PixelBytes stencil_bytes(const std::array<FaceEnds, 2>& faces,
                         Format format,
                         bool Ends::*end,
                         StencilOp StencilFace::*operation) {
    unsigned some = 0, all = 0xff;
    for (const auto& [face, ends] : faces) {
        if (!(ends.*end)) continue;
        const unsigned bits = face.*operation == StencilOp::Keep ? 0u : face.write_mask;
        some |= bits;
        all &= bits;
    }
    const ClearCommand clear{.stencil = true};
    return {cleared_depth_bytes(format, clear, some).touched,
            cleared_depth_bytes(format, clear, some & all).covered};
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
    const Stencil& stencil = state.stencil;
    const bool has_stencil = stencil.enable && format == Format::Depth24Stencil8;
    const StencilFace* const front = has_stencil ? &stencil.front : nullptr;
    const StencilFace* const back = has_stencil ? &stencil.back : nullptr;
    const Ends front_ends = possible_ends(front, depth), back_ends = possible_ends(back, depth);
    access.tests_depth =
        depth.bounds_enable || (depth.test_enable && tells(depth.compare) &&
                                (front_ends.comes_to_depth() || back_ends.comes_to_depth()));
    if (depth.test_enable && depth.write_enable && (front_ends.passed || back_ends.passed))
        access.depth = cleared_depth_bytes(format, {.depth = true}, 0);
    if (!has_stencil) return access;
    const std::array<FaceEnds, 2> faces{{{*front, front_ends}, {*back, back_ends}}};
    for (const FaceEnds& one : faces)
        access.tests_stencil = access.tests_stencil || tests_value(one.face, one.ends);
    access.passed = stencil_bytes(faces, format, &Ends::passed, &StencilFace::depth_pass);
    access.depth_failed =
        stencil_bytes(faces, format, &Ends::depth_failed, &StencilFace::depth_fail);
    access.stencil_failed = stencil_bytes(faces, format, &Ends::stencil_failed, &StencilFace::fail);
    return access;
}

std::uint32_t DepthAccess::bytes_read(Format format) const {
    const ClearCommand both{.depth = tests_depth, .stencil = tests_stencil};
    return cleared_depth_bytes(format, both, 0xff).touched;
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
