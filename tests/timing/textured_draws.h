// Draws that are bound by filling, with textures that stay in the cache and no colour written.

#pragma once

#include "tests/timing/analytic_scenes.h"
#include "tests/timing/machine_figures.h"

namespace ffgpu::timing {

constexpr unsigned FillSize = 512;
constexpr std::uint32_t FillQuads = FillSize * FillSize / 4;

// `textures` textures of their own addresses, a sample of each fragment at `level`; between two
// levels it is trilinear. Primitives of so many quads, or one.
inline WorkBin
textured_draw(unsigned textures, double level = 0, std::uint32_t quads_a_primitive = FillQuads) {
    WorkBin bin = make_bin({FillSize, FillSize, 32, [level](double x, double y, SceneSample& s) {
                                s = {.u = x, .v = y, .lambda = level, .trilinear = level > 0};
                                return true;
                            }});
    auto state = std::make_shared<Registers>(*bin.draws[0].state);
    state->blend.write_mask = 0;
    for (unsigned unit = 1; unit < textures; ++unit) {
        state->images[unit] = state->images[0];
        state->images[unit].address += unit << 20;
    }
    bin.draws[0].state = state;
    std::uint32_t quads = 0;
    for (WorkBatch& batch : bin.tiles[0].batches) {
        for (WorkQuad& quad : batch.quads)
            quad.primitive = quads++ / quads_a_primitive;
        for (unsigned unit = 1; unit < textures; ++unit) {
            batch.textures.push_back(batch.textures[0]);
            batch.textures.back().unit = static_cast<std::uint8_t>(unit);
        }
    }
    return bin;
}

// A machine of which nothing but the fragment pipes is narrow.
inline TimingConfig wide_machine(std::uint32_t pipes) {
    TimingConfig config;
    config.raster.quads_per_cycle = pipes;
    config.memory.profile = MemoryProfile::Ideal;
    config.memory.apply_profile();
    config.memory.channels = 16;
    config.memory.interleave_bytes = 64;
    config.memory.bytes_per_cycle = 256;
    return config;
}

// Of a draw from its decoding to the last quad: the pipe's latencies, and the first texels'.
inline std::uint64_t fill_and_drain(const TimingConfig& config) {
    return config.command_processor.draw_cycles + config.vertex.latency + config.fragment.latency +
           config.memory.latency;
}

} // namespace ffgpu::timing
