// VertexBatch: up to 64 vertices in structure-of-arrays form, as they pass through the stages.
// Lanes behind the last vertex are computed as well and never used.

#pragma once

#include "model/device/registers/vertex.h"

#include <array>
#include <cstdint>

namespace ffgpu {

constexpr unsigned BatchVertices = 64;

// One number of each vertex.
struct Plane {
    alignas(64) std::array<float, BatchVertices> lanes{};

    const float* at(unsigned lane) const { return lanes.data() + lane; }
    float* at(unsigned lane) { return lanes.data() + lane; }
};

using Planes3 = std::array<Plane, 3>;
using Planes4 = std::array<Plane, 4>;

struct VertexBatch {
    unsigned count = 0;
    bool whole_chunk = false; // Its vertices' primitives have no others.

    std::array<Planes4, Attributes> in; // as fetched; constants where the vertices have none

    Planes4 eye;    // homogeneous eye coordinates
    Planes3 view;   // the same divided by w
    Planes3 normal; // in eye space, after NormalMode

    Planes4 clip;
    Planes4 window; // x and y (the bits of 24.8 integers), depth, 1 / w
    alignas(64) std::array<std::uint32_t, BatchVertices> codes{}; // ClipCode bits

    std::array<Planes4, 2> color;     // front and back, in [0, 1]
    std::array<Planes3, 2> secondary; // the same
    std::array<Planes4, TextureUnits> tex;
    Plane fog;
    Plane point_size;
};

} // namespace ffgpu
