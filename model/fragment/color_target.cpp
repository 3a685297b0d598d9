#include "model/fragment/color_target.h"

#include "model/arith/srgb.h"
#include "model/fragment/lane_access.h"

namespace ffgpu {
namespace {

// The colour in the precision of the target: as it reads once it is stored.
PixelColor in_target(const ColorStage& stage, Format format, const ColoredFragment& fragment) {
    const std::uint32_t word = pack_rgba8(fragment.color);
    const bool dithers = stage.dither && is_narrow(format);
    const Dithered dithered{bayer_threshold(fragment.x, fragment.y)};
    const std::uint32_t pixel =
        dithers ? pack_pixel(format, word, dithered) : pack_pixel(format, word);
    return unpack_rgba8(unpack_pixel(format, pixel));
}

} // namespace

ColorStage compile_color_stage(const Blend& blend, bool dither) {
    ColorStage stage{.state = blend, .operation = color_operation(blend), .dither = dither};
    if (stage.operation == ColorOperation::Blend) stage.kernel = choose_blend_kernel(blend);
    return stage;
}

PixelColor
blended_color(const ColorStage& stage, bool srgb, PixelColor source, const PixelColor& stored) {
    if (stage.operation == ColorOperation::Blend)
        return srgb ? blend_srgb(stage.state, source, stored) : blend(stage.state, source, stored);
    return srgb ? unpack_rgba8(srgb_encoded_rgba8(pack_rgba8(source))) : source;
}

PixelColor written_color(const ColorStage& stage,
                         const ColorTarget& target,
                         ColoredFragment fragment,
                         const PixelColor& stored) {
    const Format format = target.surface.format;
    fragment.color = blended_color(stage, target.srgb, fragment.color, stored);
    PixelColor color = in_target(stage, format, fragment);
    if (stage.operation == ColorOperation::Logic && !target.srgb)
        color = unpack_rgba8(
            apply_logic_op(stage.state.logic_op, pack_rgba8(color), pack_rgba8(stored)));
    for (unsigned channel = 0; channel < 4; ++channel)
        if ((target.write_mask >> channel & 1) == 0) color[channel] = stored[channel];
    return color;
}

void write_color_scalar(const ColorStage& stage,
                        const ColorTarget& target,
                        const FragmentBatch& batch,
                        std::span<std::byte> memory) {
    if (target.write_mask == 0) return;
    const Format format = target.surface.format;
    for (unsigned lane = 0; lane < batch.lanes(); ++lane) {
        if (!batch.live.test(lane)) continue;
        const auto [x, y] = lane_position(batch, lane);
        std::byte* const at = pixel_address(target.surface, memory, x, y);
        const PixelColor stored = unpack_rgba8(load_rgba8(format, at));
        const PixelColor color =
            written_color(stage, target, {x, y, lane_color(batch.color, lane)}, stored);
        store_rgba8(format, pack_rgba8(color), at);
    }
}

} // namespace ffgpu
