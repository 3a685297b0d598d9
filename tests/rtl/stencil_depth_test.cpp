// rtl/stencil_depth.sv against test_stencil_depth().

#include "Vstencil_depth.h"
#include "model/device/compare.h"
#include "model/fragment/depth_target.h"
#include "rtl/bundles/quad.h"
#include "rtl/bundles/state.h"
#include "tests/rtl/bench/random_quad.h"
#include "tests/rtl/bench/unit_bench.h"

#include <catch2/catch.hpp>

namespace ffgpu::rtl {
namespace {

struct StencilDepth {
    static constexpr const char* Name = "stencil_depth";
    static constexpr std::string_view Latency = "StencilDepthLatency";
    static constexpr std::uint64_t ShortItems = 150000, LongItems = 2500000;
    static constexpr std::array Formats{
        Format::None, Format::Depth16, Format::Depth24Stencil8, Format::Rgba8};

    using Dut = Vstencil_depth;
    using State = StencilDepthWords;
    using Input = TargetQuad;
    using Output = WrittenQuad;

    static void set_tag(TargetQuad& target, unsigned tag) { target.quad.tag = tag != 0; }

    // Stored values and bounds near each other, so that comparisons meet all sides; or anything, so
    // that each bit of them decides.
    static std::uint32_t random_depth(Random& random) {
        static constexpr std::array<std::uint32_t, 5> Around{0, 0x8000, 0xffff, 0x800000, 0xffffff};
        if (random.one_in(4)) return random.word() >> 8;
        return (Around[random.below(5)] + random.below(3) - 1) & 0xffffff;
    }
    static StencilFace random_face(Random& random) {
        return {random.any<Compare>(8),
                random.any<StencilOp>(8),
                random.any<StencilOp>(8),
                random.any<StencilOp>(8),
                random.byte(),
                random.one_in(2) ? std::uint8_t{255} : random.byte(),
                random.one_in(2) ? std::uint8_t{255} : random.byte()};
    }
    static State random_state(Random& random) {
        return {{.enable = !random.one_in(4),
                 .front = random_face(random),
                 .back = random_face(random)},
                {.test_enable = !random.one_in(4),
                 .write_enable = random.one_in(2),
                 .compare = random.any<Compare>(8),
                 .bounds_enable = random.one_in(3),
                 .bounds_min = random_depth(random),
                 .bounds_max = random_depth(random)},
                Formats[random.one_in(6) ? random.below(4) : 1 + random.below(2)]};
    }
    static TargetQuad random_input(Random& random, const State& state) {
        TargetQuad target{.quad = random_quad(random)};
        for (unsigned lane = 0; lane < Lanes; ++lane) {
            target.quad.depth[lane] = random_depth(random);
            const StencilFace& face =
                target.quad.front_facing ? state.stencil.front : state.stencil.back;
            const std::uint32_t stencil = random.one_in(3) ? face.reference : random.byte();
            // Some differ in a single bit from what they are compared with.
            const std::array compared{
                target.quad.depth[lane], state.depth.bounds_min, state.depth.bounds_max};
            const std::uint32_t stored = random.one_in(3)
                                             ? compared[random.below(3)] ^ 1u << random.below(24)
                                             : random_depth(random);
            target.pixels[lane] = stored << 8 | stencil;
            if (state.format == Format::Depth16) target.pixels[lane] = stored;
        }
        return target;
    }

    // A target of another kind of format is left out, as the model's fragment pipe does it.
    static StencilDepthState compile(const State& state) {
        const Format format = is_depth_target(state.format) ? state.format : Format::None;
        return compile_stencil_depth(state.stencil, state.depth, format);
    }
    static StencilDepthPixel stored(const State& state, std::uint32_t pixel) {
        return load_stencil_depth(state.format, reinterpret_cast<const std::byte*>(&pixel));
    }

    static void declare(Bins& bins) {
        bins.declare("format", 4);
        bins.declare("outside, fails stencil, fails depth, passes", 4);
        bins.declare("stencil comparison", 8);
        bins.declare("stencil operation at 0, between, 255", 8 * 3);
        bins.declare("depth comparison: below, equal, above", 8 * 3);
        bins.declare("facing", 2);
    }
    static void cover(Bins& bins, const State& state, const TargetQuad& target) {
        const auto format = std::find(Formats.begin(), Formats.end(), state.format);
        bins.hit("format", static_cast<std::size_t>(format - Formats.begin()));
        const StencilDepthState compiled = compile(state);
        const bool front = target.quad.front_facing;
        bins.hit("facing", front);
        const StencilFace& face = front ? state.stencil.front : state.stencil.back;
        for (unsigned lane = 0; lane < Lanes; ++lane) {
            const StencilDepthPixel at = stored(state, target.pixels[lane]);
            const std::uint32_t depth = target.quad.depth[lane];
            const StencilDepthResult result = test_stencil_depth(compiled, front, depth, at);
            const bool inside = in_bounds(compiled, at);
            bins.hit("outside, fails stencil, fails depth, passes",
                     !inside                  ? 0
                     : !result.passes_stencil ? 1
                     : !result.passes_depth   ? 2
                                              : 3);
            if (inside && compiled.depth.test_enable)
                bins.hit("depth comparison: below, equal, above",
                         3 * static_cast<unsigned>(compiled.depth.compare) + (depth >= at.depth) +
                             (depth > at.depth ? 1u : 0u));
            if (!inside || !compiled.stencil) continue;
            bins.hit("stencil comparison", static_cast<unsigned>(face.compare));
            const StencilOp op = !result.passes_stencil ? face.fail
                                 : result.passes_depth  ? face.depth_pass
                                                        : face.depth_fail;
            bins.hit("stencil operation at 0, between, 255",
                     3 * static_cast<unsigned>(op) + (at.stencil > 0) +
                         (at.stencil == 255 ? 1u : 0u));
        }
    }

    static bool in_bounds(const StencilDepthState& state, const StencilDepthPixel& at) {
        return !state.depth.bounds_enable ||
               (at.depth >= state.depth.bounds_min && at.depth <= state.depth.bounds_max);
    }

    static void expect(const State& state, const TargetQuad& input, std::vector<Output>& outputs) {
        const StencilDepthState compiled = compile(state);
        WrittenQuad written{.quad = input.quad, .pixels = input.pixels};
        for (unsigned lane = 0; lane < Lanes; ++lane) {
            const StencilDepthPixel at = stored(state, input.pixels[lane]);
            const StencilDepthResult result =
                test_stencil_depth(compiled, input.quad.front_facing, input.quad.depth[lane], at);
            if (!result.passes_depth) written.quad.live &= static_cast<std::uint8_t>(~(1u << lane));
            if (!input.quad.is_live(lane)) continue;
            if (is_depth_target(state.format))
                store_stencil_depth(state.format,
                                    result.pixel,
                                    reinterpret_cast<std::byte*>(&written.pixels[lane]));
            const bool depth = result.passes_depth && compiled.depth.write_enable;
            const bool stencil = compiled.stencil && in_bounds(compiled, at);
            const unsigned depth_bytes = state.format == Format::Depth16 ? 0x3 : 0xe;
            written.enables[lane] =
                static_cast<std::uint8_t>((depth ? depth_bytes : 0) | (stencil ? 1u : 0u));
        }
        outputs.push_back(written);
    }
    static void settle(Output& written) {
        for (unsigned lane = 0; lane < Lanes; ++lane)
            if (written.enables[lane] == 0) written.pixels[lane] = 0;
    }
};
using Unit = StencilDepth;

// Every operation on every stencil value and reference: 2^19 inputs.
TEST_CASE("stencil operations equal the model's on every value and reference") {
    StencilDepth unit;
    UnitBench<StencilDepth> bench(unit);
    const auto state = [](unsigned n) {
        StencilDepth::State result;
        result.format = Format::Depth24Stencil8;
        result.stencil.enable = true;
        result.stencil.front.depth_pass = static_cast<StencilOp>(n & 7);
        result.stencil.front.reference = static_cast<std::uint8_t>(n >> 3);
        return result;
    };
    const auto input = [](unsigned, unsigned i) {
        TargetQuad target{.quad = {.live = 0xf, .front_facing = true}};
        for (unsigned lane = 0; lane < Lanes; ++lane)
            target.pixels[lane] = Lanes * i + lane;
        return target;
    };
    bench.run(counted_source<StencilDepth>(8 * 256, 64, state, input), Stall::Never, 1);
    INFO(bench.report);
    CHECK(bench.mismatches == 0);
    CHECK(bench.compared == 8 * 256 * 64);
}

} // namespace
} // namespace ffgpu::rtl

#include "tests/rtl/bench/unit_tests.inl"
