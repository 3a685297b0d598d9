// Depth bounds, stencil test and depth test: one visit to the depth target (GL 1.5, 4.1.5, 4.1.6;
// EXT_depth_bounds_test).
//
// In this order: a fragment outside the depth bounds dies and leaves the stencil alone; one that
// fails the stencil test dies and applies `fail`; the depth test chooses between `depth_fail` and
// `depth_pass`; what passes writes its depth. Depths are compared as integers in the units of the
// target, and so are the bounds.

#pragma once

#include "model/device/registers/fragment.h"
#include "model/fragment/quad_access.h"
#include "model/packets/fragment_batch.h"

#include <cstdint>

namespace ffgpu {

// The registers that matter for one draw, reduced to what its target can do: what the target
// lacks is switched off.
struct StencilDepthState {
    Format format = Format::None;
    bool stencil = false;
    DepthControl depth;
    StencilFace front, back;

    bool active() const { return stencil || depth.test_enable || depth.bounds_enable; }
    bool writes() const { return stencil || depth.write_enable; }
};

StencilDepthState
compile_stencil_depth(const Stencil& stencil, const DepthControl& depth, Format format);

// A pixel of the target: 24 or 16 bits of depth, and the stencil value.
struct StencilDepthPixel {
    std::uint32_t depth = 0;
    std::uint8_t stencil = 0;

    bool operator==(const StencilDepthPixel&) const = default;
};

struct StencilDepthResult {
    bool passes_stencil = false; // and the depth bounds
    bool passes_depth = false;   // and what comes before
    StencilDepthPixel pixel;     // to be stored
};

// The specification, for one fragment.
StencilDepthResult test_stencil_depth(const StencilDepthState& state,
                                      bool front_facing,
                                      std::uint32_t fragment_depth,
                                      StencilDepthPixel stored);

std::uint8_t apply_stencil_op(StencilOp op, std::uint8_t stored, std::uint8_t reference);

// --- On batches -------------------------------------------------------------------------------

struct StencilDepthFates {
    FragmentMask after_stencil, after_depth;
};

// Tests the live fragments against `pixels` (depth << 8 | stencil; depths of 16 bits as they are)
// and puts there what is to be stored: for a fragment that ends in after_depth, and with stencil
// for every live one. The words of other lanes are left undefined.
StencilDepthFates
test_stencil_depth(const StencilDepthState& state, const FragmentBatch& batch, LaneWords& pixels);

} // namespace ffgpu
