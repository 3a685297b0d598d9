// What travels between the units: small values that point into prepared bins.

#pragma once

#include "model/timing/prepared_work.h"

namespace ffgpu::timing {

struct DrawToken {
    PreparedBin* bin = nullptr;
    std::uint32_t draw = 0;

    PreparedDraw& prepared() const { return bin->draws[draw]; }
};

struct VertexToken {
    DrawToken draw;
    std::uint32_t position = 0; // in the draw's sequence of vertices
    bool shade = false;         // false: the post-transform reuse had it
};

struct PrimitiveToken {
    DrawToken draw;
    std::uint32_t primitive = 0;
    bool last = false; // of its draw
};

// A primitive that was set up, with its quads (immediate machines; tile-based ones take the bin's).
struct SetupToken {
    DrawToken draw;
    std::uint32_t begin = 0, end = 0;
    bool last = false; // of its draw
};

struct QuadToken {
    PreparedBin* bin = nullptr;
    std::uint32_t index = 0;
    std::uint32_t misses = 0; // texel lines that were not in the cache

    const PreparedQuad& quad() const { return bin->quads[index]; }
    const PreparedDraw& draw() const { return bin->draws[quad().draw]; }
};

} // namespace ffgpu::timing
