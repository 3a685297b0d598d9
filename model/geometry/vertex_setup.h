// VertexSetup: what the vertex stages need to know of a draw, derived from its registers once.

#pragma once

#include "model/device/registers.h"
#include "model/geometry/clip_code.h"
#include "model/geometry/light_setup.h"
#include "model/geometry/vertex_batch.h"
#include "model/packets/interpolants.h"

#include <array>
#include <cstdint>

namespace ffgpu {

// What the primitives of the draw ask of their vertices besides the interpolants.
struct VertexNeeds {
    bool point_size = false;
    bool edge_flag = false;

    bool operator==(const VertexNeeds&) const = default;
};

// Window coordinates are scale * ndc + offset.
struct WindowSetup {
    std::array<float, 3> scale{}, offset{};
    bool visible = false; // The viewport has an area.
    // Polygons are clipped to x in [low_x, high_x] and y alike, in normalised device coordinates:
    // the view volume, or the guard band where no pixel outside the viewport can be drawn.
    float low_x = -1, high_x = 1, low_y = -1, high_y = 1;
    // What window depth is clamped to; further than rounding only where depth is clamped instead of
    // clipped.
    float low_depth = 0, high_depth = 1;
    ClipCode near_code = clip_code::Near, far_code = clip_code::Far; // beyond these planes
};

WindowSetup make_window_setup(const Registers& registers);

struct TexCoordUnit {
    unsigned unit = 0;
    unsigned components = 0; // that are carried on
    bool generate = false;   // at least one coordinate
    const TexCoordSetup* registers = nullptr;
};

struct VertexSetup {
    const Registers* registers = nullptr;
    InterpolantLayout layout;
    VertexNeeds needs;

    std::array<bool, Attributes> read{}; // the attributes that the stages use
    Mat4 model_view_projection{};
    bool needs_eye = false;    // homogeneous eye coordinates
    bool needs_view = false;   // eye coordinates divided by w
    bool eye_w_is_one = false; // they are the same
    bool needs_normal = false;
    bool needs_two_sides = false; // back colours are computed
    LightingSetup lighting;       // enable: colours come from it
    unsigned unit_count = 0;      // texture units whose coordinates are generated or transformed
    std::array<TexCoordUnit, TextureUnits> units;
    bool attenuates_points = false;
    WindowSetup window;
};

// The registers must outlive the set-up.
VertexSetup
make_vertex_setup(const Registers& registers, const InterpolantLayout& layout, VertexNeeds needs);

// The plane from which each interpolant is taken, by its place in the layout.
using InterpolantSources = std::array<const Plane*, MaxInterpolants>;
InterpolantSources interpolant_sources(const VertexSetup& setup, const VertexBatch& batch);

} // namespace ffgpu
