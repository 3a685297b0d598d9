// Work streams made by formula: the scenes of the texture-cache literature without a rasterizer.

#pragma once

#include "model/packets/work_stream.h"

#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <utility>

namespace ffgpu::timing {

// One fragment's reads: texel coordinates of level 0 and level of detail.
struct SceneSample {
    double u = 0, v = 0;
    double lambda = 0;
    bool trilinear = false;
};

struct Scene {
    unsigned width = 0, height = 0; // pixels
    unsigned texture_size = 0;      // texels, repeated
    // Pixel centres are at x + 0.5, y + 0.5; false: the pixel is not drawn.
    std::function<bool(double x, double y, SceneSample&)> sample;
};

// A screen-aligned picture of a texture, one texel a pixel.
inline Scene planar_scene(unsigned size) {
    return {size, size, size, [](double x, double y, SceneSample& s) {
                s = {.u = x, .v = y};
                return true;
            }};
}

// The same, turned by an angle about the picture's centre.
inline Scene turned_scene(unsigned size, double degrees) {
    const double angle = degrees * std::acos(-1.0) / 180;
    const auto exact = [](double part) { return std::fabs(part) < 1e-12 ? 0 : part; }; // at 90
    const double c = exact(std::cos(angle)), s = exact(std::sin(angle)), centre = size / 2.0;
    return {size, size, size, [=](double x, double y, SceneSample& sample) {
                sample = {.u = c * (x - centre) - s * (y - centre),
                          .v = s * (x - centre) + c * (y - centre)};
                return true;
            }};
}

// A never-repeated texture at one level of detail everywhere, trilinear.
inline Scene uniform_level_scene(unsigned size, double level) {
    const double scale = std::exp2(level);
    return {size, size, 2 * size, [=](double x, double y, SceneSample& s) {
                s = {.u = x * scale, .v = y * scale, .lambda = level, .trilinear = true};
                return true;
            }};
}

// The perspective floor: 640x480, horizon at 0.3 of the height.
inline Scene floor_scene(unsigned texture_size) {
    const double repeat = texture_size == 256 ? 1.0 : 0.25;
    const double scale = texture_size * repeat;
    const auto place = [=](double x, double y, double& u, double& v) {
        const double horizon = 0.3 * 480, focal = 0.9 * 480;
        const double distance = focal / (y - horizon);
        const double across = (x - 320) / focal * distance;
        u = (std::cos(0.4) * across - std::sin(0.4) * distance) * scale;
        v = (std::sin(0.4) * across + std::cos(0.4) * distance) * scale;
    };
    return {640, 480, texture_size, [=](double x, double y, SceneSample& s) {
                if (y - 0.3 * 480 <= 0.5) return false;
                double ux, vx, uy, vy;
                place(x, y, s.u, s.v);
                place(x + 1, y, ux, vx);
                place(x, y + 1, uy, vy);
                s.lambda = std::log2(
                    std::max(std::hypot(ux - s.u, vx - s.v), std::hypot(uy - s.u, vy - s.v)));
                s.trilinear = true;
                return true;
            }};
}

// The scene as one draw of one primitive in a work bin. With several samples a pixel depth is
// tested and written as well.
inline WorkBin make_bin(const Scene& scene, std::uint8_t samples = 1) {
    auto registers = std::make_shared<Registers>();
    std::uint32_t levels = 1;
    while ((scene.texture_size >> levels) > 0)
        ++levels;
    registers->images[0].shape = {.kind = TextureKind::TwoD,
                                  .format = Format::Rgba8,
                                  .width = scene.texture_size,
                                  .height = scene.texture_size,
                                  .levels = levels};
    registers->targets.color[0] = {.address = 1 << 26,
                                   .format = Format::Rgba8,
                                   .width = static_cast<std::uint16_t>(scene.width),
                                   .height = static_cast<std::uint16_t>(scene.height),
                                   .stride = scene.width * 4,
                                   .samples = samples};
    if (samples > 1) {
        registers->depth = {.test_enable = true, .write_enable = true};
        registers->targets.depth = registers->targets.color[0];
        registers->targets.depth.address = 1 << 27;
        registers->targets.depth.format = Format::Depth24Stencil8;
    }

    WorkBin bin;
    WorkDraw& draw = bin.draws.emplace_back();
    draw.state = registers;
    draw.early_depth = true;
    WorkTile& tile = bin.tiles.emplace_back();
    WorkBatch batch{.draw = 0};
    TexelFootprints footprints;
    const auto end_batch = [&] {
        batch.textures.push_back(std::exchange(footprints, {}));
        tile.batches.push_back(std::exchange(batch, {.draw = 0}));
    };
    for (unsigned y = 0; y < scene.height; y += 2) {
        for (unsigned x = 0; x < scene.width; x += 2) {
            WorkQuad quad{.primitive = 0,
                          .piece = 0,
                          .x = static_cast<std::uint16_t>(x),
                          .y = static_cast<std::uint16_t>(y),
                          .covered = 0,
                          .after_early_depth = 0,
                          .after_coverage = 0,
                          .after_alpha = 0,
                          .after_stencil = 0,
                          .after_depth = 0};
            for (unsigned lane = 0; lane < 4; ++lane) {
                SceneSample s;
                if (!scene.sample(x + lane % 2 + 0.5, y + lane / 2 + 0.5, s)) continue;
                quad.covered |= static_cast<std::uint8_t>(1u << lane);
                if (samples > 1)
                    quad.samples_covered |= static_cast<std::uint16_t>(0xfu << 4 * lane);
                const auto read = [&](std::uint32_t level) {
                    const std::int64_t size = scene.texture_size >> level;
                    const double scale = std::exp2(-static_cast<double>(level));
                    const auto i = static_cast<std::int64_t>(std::floor(s.u * scale - 0.5));
                    const auto j = static_cast<std::int64_t>(std::floor(s.v * scale - 0.5));
                    const auto wrap = [&](std::int64_t k) {
                        return static_cast<std::uint16_t>(k & (size - 1));
                    };
                    footprints.add(
                        {.lane = static_cast<std::uint16_t>(4 * batch.quads.size() + lane),
                         .level = static_cast<std::uint8_t>(level),
                         .linear = 3,
                         .x0 = wrap(i),
                         .x1 = wrap(i + 1),
                         .y0 = wrap(j),
                         .y1 = wrap(j + 1),
                         .layer0 = 0,
                         .layer1 = 0});
                };
                const double clamped = std::fmax(s.lambda, 0.0);
                const auto level =
                    static_cast<std::uint32_t>(std::fmin(std::floor(clamped), levels - 1.0));
                read(level);
                if (s.trilinear && s.lambda > 0 && level + 1 < levels) read(level + 1);
            }
            if (quad.covered == 0) continue;
            quad.after_early_depth = quad.after_coverage = quad.after_alpha = quad.after_stencil =
                quad.after_depth = quad.covered;
            quad.samples_written = quad.samples_covered;
            batch.quads.push_back(quad);
            if (batch.quads.size() == BatchQuads) end_batch();
        }
        end_batch();
    }
    return bin;
}

} // namespace ffgpu::timing
