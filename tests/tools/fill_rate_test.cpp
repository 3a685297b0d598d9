// Fill rates of full screens on the presets, against those that were measured on the boards:
// T. Pabst, NVIDIA Strikes Back: The GeForce2 Ultra 3D Monster, Tom's Hardware 2000, 3DMark2000's
// fill rate test at 1024 x 768. Nothing in a preset is fitted to them.

#include "model/timing/gpu_timing.h"
#include "tools/config/config_file.h"

#include <iostream>
#include <memory>
#include <string>

#include <catch2/catch.hpp>
#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

constexpr std::uint16_t Width = 1024, Height = 768, TextureSize = 256;

struct Layer {
    unsigned bits = 16; // of colours, of depth and of texels
    unsigned textures = 1;
};

Surface surface(DeviceAddress at, Format format) {
    return {.address = at,
            .format = format,
            .width = Width,
            .height = Height,
            .stride = std::uint32_t{Width} * format_info(format).block_bytes};
}

std::shared_ptr<const Registers> state_of(const Layer& layer) {
    auto state = std::make_shared<Registers>();
    const bool narrow = layer.bits == 16;
    state->targets.color[0] = surface(1 << 26, narrow ? Format::Rgb565 : Format::Rgba8);
    state->targets.depth = surface(1 << 27, narrow ? Format::Depth16 : Format::Depth24Stencil8);
    state->depth = {.test_enable = true, .write_enable = true};
    for (unsigned unit = 0; unit < layer.textures; ++unit) {
        state->combiners[unit].enable = true;
        state->images[unit].address = (1 << 28) + (unit << 20);
        state->images[unit].shape = {.kind = TextureKind::TwoD,
                                     .format = narrow ? Format::Rgb565 : Format::Rgba8,
                                     .width = TextureSize,
                                     .height = TextureSize,
                                     .levels = 1};
    }
    return state;
}

// The texels of a pixel where the texture lies once over the screen.
TexelAccess bilinear(unsigned x, unsigned y, std::uint16_t lane) {
    const auto u = static_cast<std::uint16_t>(x * TextureSize / Width);
    const auto v = static_cast<std::uint16_t>(y * TextureSize / Height);
    const auto next = [](std::uint16_t i) {
        return static_cast<std::uint16_t>((i + 1) % TextureSize);
    };
    return {.lane = lane,
            .level = 0,
            .linear = 3,
            .x0 = u,
            .x1 = next(u),
            .y0 = v,
            .y1 = next(v),
            .layer0 = 0,
            .layer1 = 0};
}

// One quad over the screen.
std::shared_ptr<const work::WholeCommand> full_screen(const Layer& layer) {
    auto command = std::make_shared<work::WholeCommand>();
    command->draw.early_depth = true;
    command->draw.state = state_of(layer);
    GeometryWork& geometry = command->draw.geometry;
    geometry.vertex_bytes = 32;
    geometry.vertices = {0, 1, 2, 3};
    geometry.primitives = {{.key = 0, .last_vertex = 3, .pieces = 1}};
    geometry.pieces = {{0, 0, Width, Height}};
    for (unsigned unit = 0; unit < layer.textures; ++unit)
        command->units.push_back(static_cast<std::uint8_t>(unit));
    for (std::uint16_t y = 0; y < Height; y += 2)
        for (std::uint16_t x = 0; x < Width; x += 2) {
            command->quads.push_back({.primitive = 0,
                                      .x = x,
                                      .y = y,
                                      .covered = 15,
                                      .after_early_depth = 15,
                                      .after_coverage = 15,
                                      .after_alpha = 15,
                                      .after_stencil = 15,
                                      .after_depth = 15});
            for (unsigned unit = 0; unit < layer.textures; ++unit) {
                for (std::uint16_t lane = 0; lane < 4; ++lane)
                    command->accesses.push_back(bilinear(x + lane % 2u, y + lane / 2u, lane));
                command->access_begin.push_back(
                    static_cast<std::uint32_t>(command->accesses.size()));
            }
        }
    return command;
}

// Megapixels a second over a frame of two layers.
double fill_rate(const std::string& preset, const Layer& layer) {
    Configuration configuration;
    read_config_file("preset:" + preset, configuration);
    timing::GpuTiming machine(configuration.timing);
    const auto command = full_screen(layer);
    machine.command(command);
    machine.command(command);
    machine.end_frame(0);
    return 2.0 * Width * Height /
           (1000.0 * configuration.timing.clock.milliseconds(machine.cycles()));
}

struct Measured {
    const char* preset;
    Layer layer;
    double peak, least, most; // megapixels a second; the range that is expected
};

TEST_CASE("Full screens fill at the rates that were measured on the chips",
          "[fill_rate][!mayfail]") {
    std::cout << "preset           bits textures  expected Mpixel/s   obtained  of peak\n";
    const auto near = [](const char* preset, Layer layer, double peak, double measured) {
        return Measured{preset, layer, peak, measured - 0.15 * peak, measured + 0.15 * peak};
    };
    // "At 32-bit color the memory bandwidth always gets in the way, usually halving the fill rate."
    const auto halved = [](const char* preset, double peak) {
        return Measured{preset, {32, 1}, peak, 0.40 * peak, 0.65 * peak};
    };
    for (const Measured& each : {near("riva_tnt", {16, 1}, 180, 140),
                                 near("riva_tnt", {16, 2}, 90, 75),
                                 near("geforce2_ultra", {16, 1}, 1000, 790),
                                 near("geforce2_ultra", {16, 2}, 1000, 800),
                                 halved("riva_tnt", 180),
                                 halved("geforce2_ultra", 1000)}) {
        const double obtained = fill_rate(each.preset, each.layer);
        std::cout << fmt::format("{:<16} {:>4} {:>8} {:>9.0f} to {:>5.0f} {:>10.0f} {:>7.2f}\n",
                                 each.preset,
                                 each.layer.bits,
                                 each.layer.textures,
                                 each.least,
                                 each.most,
                                 obtained,
                                 obtained / each.peak);
        CHECK(obtained >= each.least);
        CHECK(obtained <= each.most);
    }
}

} // namespace
} // namespace ffgpu::tools
