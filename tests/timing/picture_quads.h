// A textured picture, the lines that each of its quads reads, from the coordinates alone, and the
// fragment pipe that each goes to.

#pragma once

#include "tests/timing/textured_draws.h"

#include <algorithm>
#include <vector>

namespace ffgpu::timing {

constexpr unsigned PictureSize = 256; // of the picture and its texture
constexpr unsigned PictureTile = 8;   // of the traversal

inline WorkBin picture(Format format = Format::Rgba8) {
    WorkBin bin = make_bin(planar_scene(PictureSize));
    auto state = std::make_shared<Registers>(*bin.draws[0].state);
    state->blend.write_mask = 0;
    state->images[0].shape.format = format;
    bin.draws[0].state = state;
    return bin;
}

// The lines of 64 bytes (blocks of 4x4 texels) of each quad of the picture, in the order of the
// traversal, from the coordinates alone: pixel (x, y) reads texels x, x + 1 and y, y + 1.
struct QuadLines {
    unsigned x = 0, y = 0;
    std::vector<unsigned> lines;
};
inline std::vector<QuadLines> quads_in_order() {
    std::vector<QuadLines> quads;
    for (unsigned tile_y = 0; tile_y < PictureSize; tile_y += PictureTile)
        for (unsigned tile_x = 0; tile_x < PictureSize; tile_x += PictureTile)
            for (unsigned y = tile_y; y < tile_y + PictureTile; y += 2)
                for (unsigned x = tile_x; x < tile_x + PictureTile; x += 2) {
                    QuadLines quad{x, y, {}};
                    for (unsigned lane = 0; lane < 4; ++lane)
                        for (unsigned corner = 0; corner < 4; ++corner) {
                            const unsigned u = (x + lane % 2 + corner % 2) % PictureSize;
                            const unsigned v = (y + lane / 2 + corner / 2) % PictureSize;
                            const unsigned line = v / 4 * (PictureSize / 4) + u / 4;
                            if (std::find(quad.lines.begin(), quad.lines.end(), line) ==
                                quad.lines.end())
                                quad.lines.push_back(line);
                        }
                    quads.push_back(quad);
                }
    return quads;
}

// Where tiles are shared out a row of them begins at the pipe that its number's last four bits,
// read from the other end as a binary fraction, have of all pipes.
inline unsigned
pipe_of(const QuadLines& quad, Distribution distribution, unsigned width, unsigned pipes) {
    const unsigned row = quad.y / width;
    if (distribution != Distribution::Tiles) return row % pipes;
    double fraction = 0;
    for (unsigned bit = 0; bit < 4; ++bit)
        fraction += (row >> bit & 1) / static_cast<double>(2 << bit);
    return (quad.x / width + static_cast<unsigned>(fraction * pipes)) % pipes;
}

inline TimingConfig
caches_machine(std::uint32_t pipes, Distribution distribution, std::uint32_t width) {
    TimingConfig config = wide_machine(pipes);
    config.fragment.distribution = distribution;
    config.fragment.distribution_width = width;
    config.texel_cache.per_pipe = true;
    config.texel_cache.sets = 1;
    return config;
}

} // namespace ffgpu::timing
