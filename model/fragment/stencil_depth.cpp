#include "model/fragment/stencil_depth.h"

#include "model/device/compare.h"

namespace ffgpu {

StencilDepthState
compile_stencil_depth(const Stencil& stencil, const DepthControl& depth, Format format) {
    StencilDepthState state{.format = format,
                            .stencil = stencil.enable && format == Format::Depth24Stencil8,
                            .depth = depth,
                            .front = stencil.front,
                            .back = stencil.back};
    if (format == Format::None) state.depth = DepthControl{};
    if (!state.depth.test_enable) state.depth.write_enable = false;
    return state;
}

std::uint8_t apply_stencil_op(StencilOp op, std::uint8_t stored, std::uint8_t reference) {
    const auto byte = [](unsigned value) { return static_cast<std::uint8_t>(value); };
    switch (op) {
    case StencilOp::Keep:
        return stored;
    case StencilOp::Zero:
        return 0;
    case StencilOp::Replace:
        return reference;
    case StencilOp::Increment:
        return stored == 255 ? stored : byte(stored + 1u);
    case StencilOp::Decrement:
        return stored == 0 ? stored : byte(stored - 1u);
    case StencilOp::Invert:
        return byte(~unsigned{stored});
    case StencilOp::IncrementWrap:
        return byte(stored + 1u);
    case StencilOp::DecrementWrap:
        return byte(stored - 1u);
    }
    return stored;
}

StencilDepthResult test_stencil_depth(const StencilDepthState& state,
                                      bool front_facing,
                                      std::uint32_t fragment_depth,
                                      StencilDepthPixel stored) {
    StencilDepthResult result{.pixel = stored};
    const DepthControl& depth = state.depth;
    if (depth.bounds_enable && (stored.depth < depth.bounds_min || stored.depth > depth.bounds_max))
        return result;

    const StencilFace& face = front_facing ? state.front : state.back;
    result.passes_stencil = !state.stencil || compare(face.compare,
                                                      face.reference & face.compare_mask,
                                                      stored.stencil & face.compare_mask);
    result.passes_depth =
        result.passes_stencil &&
        (!depth.test_enable || compare(depth.compare, fragment_depth, stored.depth));

    if (state.stencil) {
        const StencilOp op = !result.passes_stencil ? face.fail
                             : result.passes_depth  ? face.depth_pass
                                                    : face.depth_fail;
        const unsigned value = apply_stencil_op(op, stored.stencil, face.reference);
        result.pixel.stencil = static_cast<std::uint8_t>((stored.stencil & ~face.write_mask) |
                                                         (value & face.write_mask));
    }
    if (result.passes_depth && depth.write_enable) result.pixel.depth = fragment_depth;
    return result;
}

} // namespace ffgpu
