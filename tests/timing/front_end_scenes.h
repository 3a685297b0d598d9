// Draws made by formula for the front end of the machine: vertices and primitives without pixels,
// and pieces with chosen quads. Costs are measured as the difference of a draw and a longer one, so
// that the pipe's fill and drain are not in them.

#pragma once

#include "tests/timing/machine_figures.h"

#include <functional>

namespace ffgpu::timing {

// Nothing but what a test narrows is narrow.
inline TimingConfig wide_front_end() {
    TimingConfig config;
    config.host.bytes_per_cycle = 0;
    config.command_processor.draw_cycles = 1;
    config.vertex.transform_cycles = 1;
    config.vertex.fetch_queue = 256;
    config.vertex.fetch_bytes_per_cycle = 0;
    config.clip.plane_cycles = 0;
    config.setup.triangle_cycles = 1;
    config.memory.profile = MemoryProfile::Ideal;
    config.memory.apply_profile();
    config.memory.channels = 16;
    config.memory.interleave_bytes = 64;
    config.memory.bytes_per_cycle = 256;
    return config;
}

// Triangles of three vertices each, of which each becomes what `like` says.
inline WorkBin triangles(std::uint32_t count, const PrimitiveWork& like) {
    WorkBin bin;
    WorkDraw& draw = bin.draws.emplace_back();
    draw.state = std::make_shared<Registers>();
    GeometryWork& geometry = draw.geometry;
    geometry.vertex_bytes = 16;
    geometry.vertex_address = 1 << 16;
    for (std::uint32_t i = 0; i < 3 * count; ++i)
        geometry.vertices.push_back(i);
    for (std::uint32_t i = 0; i < count; ++i) {
        PrimitiveWork primitive = like;
        primitive.key = i;
        primitive.last_vertex = 3 * i + 2;
        geometry.primitives.push_back(primitive);
        geometry.pieces.resize(geometry.pieces.size() + like.pieces);
    }
    return bin;
}

inline const PrimitiveWork Culled{.fate = PrimitiveFate::Culled};

// What a primitive more takes, times 1000.
inline std::uint64_t cycles_of_1000(const TimingConfig& config,
                                    const std::function<WorkBin(std::uint32_t)>& make) {
    return run(config, make(2000)).at("total_cycles") - run(config, make(1000)).at("total_cycles");
}

} // namespace ffgpu::timing
