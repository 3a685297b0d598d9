// P15: fill rates of full screens on the presets, against those that were measured on the boards:
// T. Pabst, NVIDIA Strikes Back: The GeForce2 Ultra 3D Monster, Tom's Hardware 2000, 3DMark2000's
// fill rate test at 1024 x 768. Nothing in a preset is fitted to them.

#include "model/timing/gpu_timing.h"
#include "tests/experiments/figures/all.h"
#include "tests/support/drawn_quad.h"
#include "tools/config/config_file.h"

#include <memory>
#include <string>

#include <fmt/format.h>

namespace ffgpu::experiments {
namespace {

constexpr std::uint16_t Width = 1024, Height = 768, TextureSize = 256;

// What the test is said to draw: "First test has four textured geometry layers, and the second one
// uses one geometry layer with four textures, rendered with multi-texturing." (nvnews.net, 3DMark
// 2000, Test Descriptions). Chips of two textures a pass take two passes, of which the second must
// blend. Not told is whether layers blend in the first test, and whether a second pass writes the
// depths again that it finds: a blended pass of that time did not ("not for translucent surfaces",
// P. Jaquays and B. Hook, Quake III Arena Shader Manual, 1999, depthWrite).
constexpr unsigned Textures = 4;

struct Frame {
    unsigned bits = 16;    // of colours, of depth and of texels
    unsigned textures = 1; // a layer
    // Of all passes but the first:
    bool blends = false;
    bool writes_depth = true;

    unsigned passes() const { return Textures / textures; }
};

struct Pass {
    Frame frame;
    bool is_first = true;
};

Surface surface(DeviceAddress at, Format format) {
    return {.address = at,
            .format = format,
            .width = Width,
            .height = Height,
            .stride = std::uint32_t{Width} * format_info(format).block_bytes};
}

std::shared_ptr<const Registers> state_of(const Pass& pass) {
    const Frame& frame = pass.frame;
    auto state = std::make_shared<Registers>();
    const bool narrow = frame.bits == 16;
    state->targets.color[0] = surface(1 << 26, narrow ? Format::Rgb565 : Format::Rgba8);
    state->targets.depth = surface(1 << 27, narrow ? Format::Depth16 : Format::Depth24Stencil8);
    state->depth = {.test_enable = true, .write_enable = pass.is_first || frame.writes_depth};
    state->blend.enable = !pass.is_first && frame.blends;
    state->scissor.width = Width;
    state->scissor.height = Height;
    for (unsigned unit = 0; unit < frame.textures; ++unit) {
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
std::shared_ptr<const work::WholeCommand> full_screen(const Pass& pass) {
    auto command = std::make_shared<work::WholeCommand>();
    command->draw.early_depth = true;
    command->draw.state = state_of(pass);
    GeometryWork& geometry = command->draw.geometry;
    geometry.vertex_bytes = 32;
    geometry.vertices = {0, 1, 2, 3};
    geometry.primitives = {{.key = 0, .last_vertex = 3, .pieces = 1}};
    geometry.pieces = {{0, 0, Width, Height}};
    for (unsigned unit = 0; unit < pass.frame.textures; ++unit)
        command->units.push_back(static_cast<std::uint8_t>(unit));
    for (std::uint16_t y = 0; y < Height; y += 2)
        for (std::uint16_t x = 0; x < Width; x += 2) {
            command->quads.push_back(drawn_quad(x, y));
            for (unsigned unit = 0; unit < pass.frame.textures; ++unit) {
                for (std::uint16_t lane = 0; lane < 4; ++lane)
                    command->add_access(unit, bilinear(x + lane % 2u, y + lane / 2u, lane));
            }
        }
    return command;
}

std::shared_ptr<const work::WholeCommand> clear(const Frame& frame) {
    auto command = std::make_shared<work::WholeCommand>();
    command->draw.kind = WorkKind::Clear;
    command->draw.state = state_of({frame});
    command->draw.clear = {.color = true, .depth = true};
    return command;
}

// Of the peak in texels, over a frame after the one that the screen shows meanwhile.
double of_peak(const std::string& preset, const Frame& frame, double megatexels) {
    constexpr unsigned ScreenHertz = 85; // assumed
    tools::Configuration configuration;
    tools::read_config_file("preset:" + preset, configuration);
    timing::TimingConfig& machine = configuration.timing;
    machine.scan_out.refresh_cycles = machine.clock.core_mhz * 1'000'000 / ScreenHertz;
    timing::GpuTiming timing(machine);
    timing.command(clear(frame));
    timing.end_frame(0);
    const std::uint64_t begin = timing.cycles();
    timing.command(clear(frame));
    for (unsigned pass = 0; pass < frame.passes(); ++pass)
        timing.command(full_screen({frame, pass == 0}));
    timing.end_frame(1);
    const double milliseconds = machine.clock.milliseconds(timing.cycles() - begin);
    return 1e-3 * Textures * Width * Height / milliseconds / megatexels;
}

struct Measured {
    const char* preset;
    Frame frame;
    double megatexels; // of the peak
    Range expected;    // of it
};

Measured near(const char* preset, Frame frame, double peak, double measured) {
    return {preset, frame, peak, {measured / peak - 0.15, measured / peak + 0.15}};
}

// "At 32-bit color the memory bandwidth always gets in the way, usually halving the fill rate."
Measured halved(const char* preset, double peak) {
    return {preset, {32, 1}, peak, {0.40, 0.65}};
}

// Obtained are two figures, of the passes that move the fewest bytes and of those that move the
// most: what is not told may be either, and one of them, or what lies between, has to be in the
// range.
Row fill_row(const Measured& each) {
    Frame lightest = each.frame, heaviest = each.frame;
    if (each.frame.textures > 1) {
        lightest.blends = heaviest.blends = true; // They must.
        lightest.writes_depth = false;
    } else {
        heaviest.blends = true;
    }
    const double most = of_peak(each.preset, lightest, each.megatexels);
    const double least = of_peak(each.preset, heaviest, each.megatexels);
    constexpr double Any = 10;
    return {fmt::format("{}, {} bits, {} texture{} a layer, {:.2f} to {:.2f} of {} Mtexel/s",
                        each.preset,
                        each.frame.bits,
                        each.frame.textures,
                        each.frame.textures > 1 ? "s" : "",
                        each.expected.least,
                        each.expected.most,
                        each.megatexels),
            {},
            {{"opaque layers; a second pass that leaves the depths",
              {most},
              {{each.expected.least, Any}}},
             {"blended layers; a second pass that writes them again",
              {least},
              {{0, each.expected.most}}}}};
}

} // namespace

Experiment fill_rates() {
    Table table{"Texels a second, of the peak", {"preset, range expected", "obtained"}, {}};
    tools::Plot plot{"Fill rates", "row of the table (2: the second ...)", "of the peak"};
    plot.counts = true;
    tools::PlotSeries lightest{"opaque, depths left", {}}, heaviest{"blended, depths again", {}};
    for (const Measured& each : {near("riva_tnt", {16, 1}, 180, 140),
                                 near("riva_tnt", {16, 2}, 180, 150),
                                 halved("riva_tnt", 180),
                                 near("geforce2_ultra", {16, 1}, 1000, 790),
                                 near("geforce2_ultra", {16, 2}, 2000, 1600),
                                 halved("geforce2_ultra", 1000)}) {
        table.rows.push_back(fill_row(each));
        const std::uint64_t row = table.rows.size();
        lightest.points.emplace_back(row, table.rows.back().lines[0].values[0]);
        heaviest.points.emplace_back(row, table.rows.back().lines[1].values[0]);
    }
    plot.series = {lightest, heaviest};
    return {.id = "P15",
            .title = "Fill rates of chips of the time",
            .source = "T. Pabst, NVIDIA Strikes Back: The GeForce2 Ultra 3D Monster, Tom's "
                      "Hardware 2000: 3DMark2000's fill rate test, 140 and 150 of 180 Mtexel/s, "
                      "790 of 1000 and 1600 of 2000, each to 0.15 of the peak; at 32 bits "
                      "\"usually halving\", 0.40 to 0.65",
            .method =
                "Full screens of 1024 x 768 on the [presets](presets.md#measured-on-the-chips), "
                "of which nothing is fitted.",
            .tables = {table},
            .plots = {{"p15_fill_rates", svg(plot)}}};
}

} // namespace ffgpu::experiments
