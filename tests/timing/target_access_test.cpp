// What comes from and goes to memory for a pixel of a draw's targets, by its state: counted by hand
// from the meaning of the state (OpenGL 1.5, sections 4.1 and 4.2).

#include "tests/timing/machine_figures.h"

#include <functional>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

namespace ffgpu::timing {
namespace {

constexpr std::uint16_t Width = 64, Height = 32;
constexpr std::uint64_t Pixels = std::uint64_t{Width} * Height;

// How the tests of all fragments end.
enum class Ends { Passed, DepthFailed, StencilFailed };

struct Case {
    std::string name;
    std::function<void(Registers&)> set;
    std::uint64_t read = 0, written = 0; // bytes a pixel
    Ends ends = Ends::Passed;
};

Surface target(DeviceAddress address, Format format) {
    const std::uint32_t pixel = format_info(format).block_bytes;
    return {.address = address,
            .format = format,
            .width = Width,
            .height = Height,
            .stride = Width * pixel};
}

WorkBin draw(const Case& one, bool depth) {
    WorkBin bin;
    auto state = std::make_shared<Registers>();
    if (depth)
        state->targets.depth = target(1 << 27, Format::Depth24Stencil8);
    else
        state->targets.color[0] = target(1 << 26, Format::Rgba8);
    one.set(*state);
    WorkDraw& draw = bin.draws.emplace_back();
    draw.state = state;
    WorkBatch& batch = bin.tiles.emplace_back().batches.emplace_back();
    batch.draw = 0;
    for (unsigned y = 0; y < Height; y += 2)
        for (unsigned x = 0; x < Width; x += 2) {
            WorkQuad quad{};
            quad.x = static_cast<std::uint16_t>(x);
            quad.y = static_cast<std::uint16_t>(y);
            quad.covered = quad.after_early_depth = quad.after_coverage = quad.after_alpha = 15;
            if (one.ends != Ends::StencilFailed) quad.after_stencil = 15;
            if (one.ends == Ends::Passed) quad.after_depth = 15;
            batch.quads.push_back(quad);
        }
    return bin;
}

TimingConfig machine() {
    TimingConfig config;
    config.depth_cache.transfer_bytes = config.color_cache.transfer_bytes = 1;
    config.depth_cache.layout = config.color_cache.layout = Layout::Linear;
    return config;
}

void check_cases(const std::vector<Case>& cases, const std::string& client) {
    for (const Case& one : cases) {
        INFO(one.name);
        const Figures figures = run(machine(), draw(one, client == "depth"));
        CHECK(figures.at("memory_" + client + "_read_bytes") == Pixels * one.read);
        CHECK(figures.at("memory_" + client + "_written_bytes") == Pixels * one.written);
    }
}

// A draw whose depth test is `compare`, and which writes depths.
auto depths(Compare compare, bool write = true) {
    return [=](Registers& state) {
        state.depth = {.test_enable = true, .write_enable = write, .compare = compare};
    };
}

auto stencil(const StencilFace& face) {
    return [=](Registers& state) { state.stencil = {.enable = true, .front = face, .back = face}; };
}

TEST_CASE("Depths and stencil values are read and written where the state asks for them") {
    using enum StencilOp;
    const StencilFace increments{.depth_pass = Increment}, replaces{.depth_pass = Replace};
    StencilFace half = replaces, masked = replaces, compares{.compare = Compare::Equal};
    half.write_mask = 0x0f;
    masked.write_mask = 0;
    StencilFace unmasked = compares;
    unmasked.compare_mask = 0;
    const StencilFace fails{.compare = Compare::Never, .fail = Replace};
    const StencilFace shadow{.depth_fail = IncrementWrap};
    // What no fragment comes to: a failed depth test without one, tests behind a stencil test that
    // never passes, a stencil test that a mask or the largest reference has decided.
    const StencilFace never_increments{.compare = Compare::Never, .depth_pass = Increment};
    const StencilFace unmasked_fails{
        .compare = Compare::Less, .fail = Replace, .depth_pass = Increment, .compare_mask = 0};
    const StencilFace past_the_largest{.compare = Compare::Less, .reference = 255};
    const auto behind = [](const StencilFace& face) {
        return [=](Registers& state) {
            depths(Compare::Less)(state);
            stencil(face)(state);
        };
    };
    const auto front_fails = [&](Registers& state) {
        depths(Compare::Less)(state);
        state.stencil = {.enable = true, .front = never_increments, .back = replaces};
    };
    check_cases(
        {{"less", depths(Compare::Less), 4, 3},
         {"less, masked", depths(Compare::Less, false), 4, 0},
         {"always", depths(Compare::Always), 0, 3},
         {"always, masked", depths(Compare::Always, false), 0, 0},
         {"never", depths(Compare::Never), 0, 0, Ends::DepthFailed},
         {"16 bits",
          [](Registers& state) {
              state.targets.depth = target(1 << 27, Format::Depth16);
              depths(Compare::Always)(state);
          },
          0,
          2},
         {"bounds",
          [](Registers& state) {
              depths(Compare::Always, false)(state);
              state.depth.bounds_enable = true;
          },
          4,
          0},
         {"replaces", stencil(replaces), 0, 1},
         {"replaces half of the bits", stencil(half), 4, 1},
         {"replaces none of the bits", stencil(masked), 0, 0},
         {"increments", stencil(increments), 4, 1},
         {"compares", stencil(compares), 4, 0},
         {"compares no bits", stencil(unmasked), 0, 0},
         {"fails and replaces", stencil(fails), 0, 1, Ends::StencilFailed},
         {"fails and keeps", stencil(compares), 4, 0, Ends::StencilFailed},
         {"shadow",
          [&](Registers& state) {
              depths(Compare::Less, false)(state);
              stencil(shadow)(state);
          },
          4,
          1,
          Ends::DepthFailed},
         {"shadow in the light",
          [&](Registers& state) {
              depths(Compare::Less, false)(state);
              stencil(shadow)(state);
          },
          4,
          0},
         {"increments where a depth test would fail", stencil(shadow), 0, 0},
         {"never comes to the depth test", behind(fails), 0, 1, Ends::StencilFailed},
         {"never, and would increment", behind(never_increments), 0, 0, Ends::StencilFailed},
         {"fails under its mask", behind(unmasked_fails), 0, 1, Ends::StencilFailed},
         {"fails past the largest", behind(past_the_largest), 0, 0, Ends::StencilFailed},
         {"one face comes to the depth test", front_fails, 4, 4},
         {"increments where a test that never passes lets none through",
          [&](Registers& state) {
              depths(Compare::Never)(state);
              stencil(increments)(state);
          },
          0,
          0,
          Ends::DepthFailed}},
        "depth");
}

auto blending(BlendFactor source, BlendFactor destination, std::uint8_t mask = 15) {
    return [=](Registers& state) {
        state.blend.enable = true;
        state.blend.rgb_source = state.blend.alpha_source = source;
        state.blend.rgb_destination = state.blend.alpha_destination = destination;
        state.blend.write_mask = mask;
    };
}

auto logic(LogicOp op) {
    return [=](Registers& state) {
        state.blend.logic_op_enable = true;
        state.blend.logic_op = op;
    };
}

auto mask(std::uint8_t channels, Format format = Format::Rgba8) {
    return [=](Registers& state) {
        state.targets.color[0] = target(1 << 26, format);
        state.blend.write_mask = channels;
    };
}

// A draw's depths alone come without a fetch; of what it wrote another draw needs no more.
TEST_CASE("What a depth test needs is there where a draw wrote it, and nothing else of the line") {
    struct Reading {
        std::function<void(Registers&)> set;
        unsigned first_x = 0; // of each sixteen pixels: eight from there on
        std::uint64_t read = 0;
    };
    const StencilFace equal{.compare = Compare::Equal};
    const auto less = depths(Compare::Less, false);
    const auto both = [&](Registers& state) {
        less(state);
        stencil(equal)(state);
    };
    const auto of_eight = [](WorkBin& bin, std::uint32_t number, unsigned first_x) {
        auto& quads = bin.tiles[0].batches[number].quads;
        std::erase_if(quads, [&](const WorkQuad& quad) { return quad.x % 16 / 8 != first_x / 8; });
    };
    for (const Reading& reading : {Reading{less, 0, 0},             // the very bytes
                                   Reading{both, 0, 4 * Pixels},    // stencil values, too
                                   Reading{less, 8, 4 * Pixels}}) { // other pixels of the line
        WorkBin bin = draw({"writes", depths(Compare::Always)}, true);
        const WorkBin second = draw({"reads", reading.set}, true);
        bin.draws.push_back(second.draws[0]);
        bin.tiles[0].batches.push_back(second.tiles[0].batches[0]);
        bin.tiles[0].batches[1].draw = 1;
        of_eight(bin, 0, 0);
        of_eight(bin, 1, reading.first_x);
        TimingConfig config = machine();
        config.depth_cache.sets = 1;
        config.depth_cache.ways = 4096;
        CHECK(run(config, bin).at("memory_depth_read_bytes") == reading.read);
    }
}

TEST_CASE("Colours are read where what is written depends on them, and written under the mask") {
    using enum BlendFactor;
    check_cases({{"opaque", [](Registers&) {}, 0, 4},
                 {"one, zero", blending(One, Zero), 0, 4},
                 {"source alpha, zero", blending(SourceAlpha, Zero), 0, 4},
                 {"zero, one", blending(Zero, One), 4, 4},
                 {"one, source alpha", blending(One, SourceAlpha), 4, 4},
                 {"destination colour, zero", blending(DestinationColor, Zero), 4, 4},
                 {"destination alpha, zero", blending(OneMinusDestinationAlpha, Zero), 4, 4},
                 {"least",
                  [](Registers& state) {
                      blending(One, Zero)(state);
                      state.blend.rgb_equation = BlendEquation::Min;
                  },
                  4,
                  4},
                 {"alpha alone, masked",
                  [](Registers& state) {
                      blending(One, Zero, 7)(state);
                      state.blend.alpha_destination = One;
                  },
                  0,
                  3},
                 {"copy", logic(LogicOp::Copy), 0, 4},
                 {"clear", logic(LogicOp::Clear), 0, 4},
                 {"exclusive or", logic(LogicOp::Xor), 4, 4},
                 {"noop", logic(LogicOp::Noop), 4, 4},
                 {"red", mask(1), 0, 1},
                 {"nothing", mask(0), 0, 0},
                 {"red of 565", mask(1, Format::Rgb565), 2, 2},
                 {"colours of 565", mask(7, Format::Rgb565), 0, 2},
                 {"alpha of 565", mask(8, Format::Rgb565), 0, 0}},
                "color");
}

} // namespace
} // namespace ffgpu::timing
