// Set-up: turns a primitive of window vertices into a SetupRecord.
//
//     triangle_setup.cpp   filled polygons, stippled, smooth; depth offset
//     line_setup.cpp       lines, wide, stippled, smooth
//     point_setup.cpp      points, round, sprites
//     plane_setup.cpp      the planes of depth and attributes, common to all

#pragma once

#include "model/packets/draw_state.h"
#include "model/packets/rectangle.h"
#include "model/packets/window_vertex.h"
#include "model/raster/setup_record.h"

#include <cstdint>

namespace ffgpu {

// What set-up needs of a draw's state.
struct SetupContext {
    PrimitiveSetup primitive;
    InterpolantLayout layout;
    Rectangle clip;                // scissor and targets; empty without a target
    bool multisample = false;      // Primitives cover samples; smoothing is off then.
    std::uint32_t depth_scale = 0; // the target's far plane: 2^24 - 1 or 2^16 - 1
};

SetupContext compile_setup(const DrawState& state);

// `at` has room for MaxSetupRecordBytes. Returns false where the primitive reaches no pixel's
// centre or sample with its box. A small triangle that covers none of its box's centres is told by
// at.covers_nothing; it gets its planes, which nobody will evaluate, only with `all_planes`.
bool set_up(const SetupContext& context,
            const Primitive& primitive,
            SetupRecord& at,
            bool all_planes = true);

} // namespace ffgpu
