// The test by vectors, rows of quads to and from the target.

#include "model/fragment/depth_target.h"
#include "model/fragment/quad_access.h"

namespace ffgpu {

StencilDepthFates test_depth_target(const StencilDepthState& state,
                                    const Surface& target,
                                    const FragmentBatch& batch,
                                    std::span<std::byte> memory) {
    if (!state.active() || !batch.live.any()) return {batch.live, batch.live};
    LaneWords pixels;
    const bool narrow = state.format == Format::Depth16;
    load_quads(target, memory, batch, pixels);
    if (narrow)
        for (std::uint32_t& pixel : pixels.words)
            pixel <<= 8;
    const StencilDepthFates fates = test_stencil_depth(state, batch, pixels);
    const FragmentMask& written = state.stencil ? batch.live : fates.after_depth;
    if (!state.writes() || !written.any()) return fates;
    if (narrow)
        for (std::uint32_t& pixel : pixels.words)
            pixel >>= 8;
    store_quads(target, memory, batch, written, pixels);
    return fates;
}

} // namespace ffgpu
