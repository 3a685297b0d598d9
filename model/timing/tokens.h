// What travels between the units: small values that point into scenes.

#pragma once

#include "model/work/prepared_work.h"

#include <utility>

namespace ffgpu::timing {

using work::PreparedDraw;
using work::PreparedQuad;

// Bytes of device memory that the host wrote.
struct HostWrite {
    std::uint64_t begin = 0, end = 0;
};

// A scene on its way through the machine.
struct TimedScene {
    explicit TimedScene(work::PreparedScene&& prepared)
        : work(std::move(prepared)) {}

    work::PreparedScene work;
    std::vector<HostWrite> host_writes; // before its draws; the vertex fetch takes them
    std::uint64_t finished_draws = 0;   // by the unit that read a draw last
    std::uint64_t retired_quads = 0;    // counted by the unit that ends a quad

    // No token points in here any more.
    bool is_done() const {
        return finished_draws == work.draws.size() && retired_quads == work.quads.size();
    }
};

struct DrawToken {
    TimedScene* scene = nullptr;
    std::uint32_t draw = 0;

    const PreparedDraw& prepared() const { return scene->work.draws[draw]; }
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

// A primitive that was set up, with its quads (immediate machines; tile-based ones take the
// scene's).
struct SetupToken {
    DrawToken draw;
    std::uint32_t begin = 0, end = 0;
    bool last = false; // of its draw
};

struct QuadToken {
    TimedScene* scene = nullptr;
    std::uint32_t index = 0;
    std::uint32_t misses = 0; // texel lines that were not in the cache

    const PreparedQuad& quad() const { return scene->work.quads[index]; }
    const PreparedDraw& draw() const { return scene->work.draws[quad().draw]; }
};

} // namespace ffgpu::timing
