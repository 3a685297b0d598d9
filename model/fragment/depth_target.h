// The visit to the depth target: a batch's pixels loaded, tested and stored.

#pragma once

#include "model/device/registers/fragment.h"
#include "model/fragment/stencil_depth.h"
#include "model/packets/fragment_batch.h"

#include <cstddef>
#include <span>

namespace ffgpu {

// Tests batch.depth of the live fragments. A state without any test lets all pass.
StencilDepthFates test_depth_target(const StencilDepthState& state,
                                    const Surface& target,
                                    const FragmentBatch& batch,
                                    std::span<std::byte> memory);
StencilDepthFates test_depth_target_scalar(const StencilDepthState& state,
                                           const Surface& target,
                                           const FragmentBatch& batch,
                                           std::span<std::byte> memory);

// A pixel of a target of this format.
StencilDepthPixel load_stencil_depth(Format format, const std::byte* at);
void store_stencil_depth(Format format, StencilDepthPixel pixel, std::byte* at);

} // namespace ffgpu
