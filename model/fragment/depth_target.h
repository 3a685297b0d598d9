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

} // namespace ffgpu
