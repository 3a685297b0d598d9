// The state of a GL context by chapters of the specification. Plain values whose initialisers are
// OpenGL's initial values; objects (textures, buffers, lists) are referred to by shared_ptr.

#pragma once

#include "driver/state/buffer_state.h"
#include "driver/state/current_state.h"
#include "driver/state/evaluator_state.h"
#include "driver/state/fragment_state.h"
#include "driver/state/framebuffer_state.h"
#include "driver/state/hint_state.h"
#include "driver/state/lighting_state.h"
#include "driver/state/pixel_state.h"
#include "driver/state/pixel_store_state.h"
#include "driver/state/rasterization_state.h"
#include "driver/state/texture_state.h"
#include "driver/state/transform_state.h"
#include "driver/state/vertex_array_state.h"

namespace ffgpu::gl {

// What glPushAttrib can save.
struct State {
    CurrentState current;     // colour, normal, texture coordinates ... raster position
    TransformState transform; // matrix stacks, viewport, depth range, clip planes, normalize
    LightingState lighting;   // lights, materials, colour material, shade model
    RasterizationState
        rasterization;            // points, lines, polygons, cull, offset, stipples, multisample
    TextureState texture;         // units: bindings, environment, texgen, enables
    FragmentState fragment;       // fog, scissor, alpha, stencil, depth, blend, logic op, dither
    FramebufferState framebuffer; // draw and read buffer, masks, clear values
    PixelState pixel;             // pixel transfer, maps, zoom
    EvaluatorState evaluator;     // maps and grids
    HintState hint;
};

// What glPushClientAttrib can save.
struct ClientState {
    VertexArrayState arrays;
    PixelStoreState pixel_store;
    BufferState buffers; // bindings of buffer objects
};

} // namespace ffgpu::gl
