// rtl/blend.sv against written_color(), the model's blend in a target's precision.

#include "Vblend.h"
#include "model/fragment/color_target.h"
#include "rtl/bundles/quad.h"
#include "rtl/bundles/state.h"
#include "tests/rtl/bench/random_quad.h"
#include "tests/rtl/bench/unit_bench.h"

#include <catch2/catch.hpp>

namespace ffgpu::rtl {
namespace {

struct BlendUnit {
    static constexpr const char* Name = "blend";
    static constexpr std::string_view Latency = "BlendLatency";
    static constexpr std::uint64_t ShortItems = 150000, LongItems = 2500000;
    static constexpr unsigned FormatCount = 12; // and one that is none of a colour target

    using Dut = Vblend;
    using State = BlendWords;
    using Input = TargetQuad;
    using Output = WrittenQuad;

    static void set_tag(TargetQuad& target, unsigned tag) { target.quad.tag = tag != 0; }

    // Equations and factors beyond their lists as well.
    static State random_state(Random& random) {
        const auto factor = [&] { return random.any<BlendFactor>(random.one_in(20) ? 16 : 15); };
        State state;
        state.blend = {.enable = !random.one_in(3),
                       .logic_op_enable = random.one_in(3),
                       .logic_op = random.any<LogicOp>(16),
                       .rgb_equation = random.any<BlendEquation>(random.one_in(20) ? 8 : 5),
                       .alpha_equation = random.any<BlendEquation>(random.one_in(20) ? 8 : 5),
                       .rgb_source = factor(),
                       .rgb_destination = factor(),
                       .alpha_source = factor(),
                       .alpha_destination = factor(),
                       .constant = random_color(random),
                       .write_mask =
                           static_cast<std::uint8_t>(random.one_in(2) ? 15 : random.below(16))};
        if (random.one_in(6)) // What no factor makes smaller is clamped most.
            state.blend.rgb_source = state.blend.rgb_destination = BlendFactor::One;
        state.control.dither = random.one_in(2);
        state.format = random.any<Format>(FormatCount - 1);
        if (random.one_in(30)) state.format = Format::Depth16;
        return state;
    }
    static TargetQuad random_input(Random& random, const State&) {
        TargetQuad target{.quad = random_quad(random)};
        for (std::uint32_t& pixel : target.pixels)
            pixel = random_color(random);
        return target;
    }

    static void declare(Bins& bins) {
        bins.declare("format", FormatCount);
        bins.declare("dithered format", 3);
        bins.declare("replace, blend, logic", 3);
        bins.declare("logic operation", 16);
        bins.declare("equation", 8);
        bins.declare("source factor", 16);
        bins.declare("destination factor", 16);
        bins.declare("alpha factor", 16);
        bins.declare("mask", 16);
        bins.declare("below 0, between, above 1", 3);
    }
    static void cover(Bins& bins, const State& state, const TargetQuad& target) {
        const Blend& blend = state.blend;
        const auto number = [](auto value) { return static_cast<std::size_t>(value); };
        bins.hit("format", std::min<std::size_t>(number(state.format), FormatCount - 1));
        if (is_narrow(state.format) && state.control.dither)
            bins.hit("dithered format", number(state.format) - number(Format::Rgb565));
        bins.hit("replace, blend, logic", number(color_operation(blend)));
        bins.hit("mask", blend.write_mask);
        if (blend.logic_op_enable) bins.hit("logic operation", number(blend.logic_op));
        if (color_operation(blend) != ColorOperation::Blend) return;
        bins.hit("equation", number(blend.rgb_equation));
        bins.hit("source factor", number(blend.rgb_source));
        bins.hit("destination factor", number(blend.rgb_destination));
        bins.hit("alpha factor", number(blend.alpha_source));
        const bool adds = blend.rgb_equation == BlendEquation::Add;
        if (blend.rgb_source != BlendFactor::One || blend.rgb_destination != BlendFactor::One)
            return;
        const int s = target.quad.rgba(0)[0];
        const int d = static_cast<int>(unpack_pixel(state.format, target.pixels[0]) & 255);
        const int sum = adds ? s + d : blend.rgb_equation == BlendEquation::Subtract ? s - d : 0;
        bins.hit("below 0, between, above 1", sum < 0 ? 0 : sum <= 255 ? 1 : 2);
    }

    static void expect(const State& state, const TargetQuad& input, std::vector<Output>& outputs) {
        WrittenQuad written{.quad = input.quad};
        const Format format = state.format;
        const ColorStage stage = compile_color_stage(state.blend, state.control.dither);
        const std::uint32_t mask = state.blend.write_mask & stored_channels(format);
        for (unsigned lane = 0; lane < Lanes; ++lane) {
            const PixelColor stored = unpack_rgba8(unpack_pixel(format, input.pixels[lane]));
            if (stage.operation == ColorOperation::Blend)
                written.quad.color[lane] =
                    pack_rgba8(blend(state.blend, input.quad.rgba(lane), stored));
            if (!is_plain_color(format) || !input.quad.is_live(lane) || mask == 0) continue;
            const ColorTarget target{{.format = format}, static_cast<std::uint8_t>(mask)};
            const ColoredFragment fragment{
                input.quad.x + lane % 2u, input.quad.y + lane / 2u, input.quad.rgba(lane)};
            const std::uint32_t pixel =
                pack_pixel(format, pack_rgba8(written_color(stage, target, fragment, stored)));
            // Of a pixel narrower than a word the rest is as it was.
            const unsigned bytes = format_info(format).block_bytes;
            const std::uint32_t its_bits = ~0u >> (32 - 8 * bytes);
            written.pixels[lane] = (input.pixels[lane] & ~its_bits) | (pixel & its_bits);
            written.enables[lane] = static_cast<std::uint8_t>((1u << bytes) - 1);
        }
        outputs.push_back(written);
    }
    // A pixel that is not written is whatever.
    static void settle(Output& written) {
        for (unsigned lane = 0; lane < Lanes; ++lane)
            if (written.enables[lane] == 0) written.pixels[lane] = 0;
    }
};
using Unit = BlendUnit;

// s As + d (1 - As) for every source, destination and alpha: 2^24 inputs, in the long form; of the
// short one every source and destination with 32 alphas.
TEST_CASE("translucency equals the model's on every input") {
    BlendUnit unit;
    UnitBench<BlendUnit> bench(unit);
    const unsigned step = std::getenv("FFGPU_RTL_LONG") ? 1 : 8;
    const auto state = [](unsigned) {
        return BlendUnit::State{{.enable = true,
                                 .rgb_source = BlendFactor::SourceAlpha,
                                 .rgb_destination = BlendFactor::OneMinusSourceAlpha},
                                {},
                                Format::Rgba8};
    };
    // Twelve channels, each with a destination of its own.
    const auto input = [step](unsigned n, unsigned i) {
        TargetQuad target{.quad = {.live = 0xf}};
        for (unsigned lane = 0; lane < Lanes; ++lane) {
            const unsigned destination = 12 * (i % 22) + 3 * lane;
            target.quad.color[lane] = (i / 22) * 0x010101u | (n * step) << 24;
            target.pixels[lane] = 0xffu << 24;
            for (unsigned channel = 0; channel < 3; ++channel)
                target.pixels[lane] |= std::min(destination + channel, 255u) << 8 * channel;
        }
        return target;
    };
    bench.run(counted_source<BlendUnit>(256 / step, 22 * 256, state, input), Stall::Never, 1);
    INFO(bench.report);
    CHECK(bench.mismatches == 0);
    CHECK(bench.compared == 256 / step * 22 * 256);
}

} // namespace
} // namespace ffgpu::rtl

#include "tests/rtl/bench/unit_tests.inl"
