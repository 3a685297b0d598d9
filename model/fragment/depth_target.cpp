#include "model/fragment/depth_target.h"

#include "model/fragment/lane_access.h"
#include "model/memory/pixel_format.h"

namespace ffgpu {

StencilDepthPixel load_stencil_depth(Format format, const std::byte* at) {
    if (format == Format::Depth16) return {load_word<std::uint16_t>(at), 0};
    const auto word = load_word<std::uint32_t>(at);
    return {word >> 8, static_cast<std::uint8_t>(word)};
}

void store_stencil_depth(Format format, StencilDepthPixel pixel, std::byte* at) {
    if (format == Format::Depth16) return store_word(at, static_cast<std::uint16_t>(pixel.depth));
    store_word(at, pixel.depth << 8 | pixel.stencil);
}

StencilDepthFates test_depth_target_scalar(const StencilDepthState& state,
                                           const Surface& target,
                                           const FragmentBatch& batch,
                                           std::span<std::byte> memory) {
    if (!state.active()) return {batch.live, batch.live};
    StencilDepthFates fates;
    for (unsigned lane = 0; lane < batch.lanes(); ++lane) {
        if (!batch.live.test(lane)) continue;
        const auto [x, y] = lane_position(batch, lane);
        std::byte* const at = pixel_address(target, memory, x, y);
        const StencilDepthResult result = test_stencil_depth(state,
                                                             lane_front_facing(batch, lane),
                                                             batch.depth[lane],
                                                             load_stencil_depth(state.format, at));
        if (result.passes_stencil) fates.after_stencil.set(lane);
        if (result.passes_depth) fates.after_depth.set(lane);
        store_stencil_depth(state.format, result.pixel, at);
    }
    return fates;
}

} // namespace ffgpu
