// rtl/texture_environment.sv against combine().

#include "Vtexture_environment.h"
#include "model/fragment/texture_environment.h"
#include "rtl/bundles/quad.h"
#include "rtl/bundles/state.h"
#include "tests/rtl/bench/random_quad.h"
#include "tests/rtl/bench/unit_bench.h"

#include <catch2/catch.hpp>

namespace ffgpu::rtl {
namespace {

struct TextureEnvironment {
    static constexpr const char* Name = "texture_environment";
    static constexpr std::string_view Latency = "TextureEnvironmentLatency";
    static constexpr std::uint64_t ShortItems = 1000000, LongItems = 2500000;

    using Dut = Vtexture_environment;
    using State = EnvironmentWords;
    using Input = ShadeQuad;
    using Output = ShadeQuad;

    static void set_tag(ShadeQuad& shaded, unsigned tag) { shaded.quad.tag = tag != 0; }

    // Sources and operations beyond their lists as well.
    static CombineHalf random_half(Random& random) {
        CombineHalf half{.op = random.any<CombineOp>(random.one_in(4) ? 16 : 13),
                         .scale_shift = static_cast<std::uint8_t>(random.below(4))};
        for (CombineArgument& argument : half.arguments)
            argument = {random.any<CombineSource>(random.one_in(4) ? 16 : 13),
                        random.any<CombineOperand>(4)};
        return half;
    }
    static State random_state(Random& random) {
        return {{.enable = !random.one_in(8),
                 .rgb = random_half(random),
                 .alpha = random_half(random),
                 .constant = random_color(random)},
                random.byte()};
    }
    static ShadeQuad random_input(Random& random, const State&) {
        return random_shade_quad(random);
    }

    static void declare(Bins& bins) {
        bins.declare("enabled", 2);
        bins.declare("operation and scale", 16 * 4);
        bins.declare("alpha operation and scale", 16 * 4);
        bins.declare("source and operand", 16 * 4);
        bins.declare("unit sampled", 2 * TextureUnits);
        bins.declare("result 0, between, 255", 3);
    }
    static void cover(Bins& bins, const State& state, const ShadeQuad& shaded) {
        const auto number = [](auto value) { return static_cast<std::size_t>(value); };
        const Combiner& combiner = state.combiner;
        bins.hit("enabled", combiner.enable);
        if (!combiner.enable) return;
        bins.hit("operation and scale", 4 * number(combiner.rgb.op) + combiner.rgb.scale_shift);
        if (combiner.rgb.op != CombineOp::Dot3Rgba)
            bins.hit("alpha operation and scale",
                     4 * number(combiner.alpha.op) + combiner.alpha.scale_shift);
        const CombineArgument& first = combiner.rgb.arguments[0];
        bins.hit("source and operand", 4 * number(first.source) + number(first.operand));
        if (number(first.source) < TextureUnits)
            bins.hit("unit sampled",
                     2 * number(first.source) + (state.sampled_units >> number(first.source) & 1u));
        const std::uint8_t red = result(state, shaded, 0)[0];
        bins.hit("result 0, between, 255", red == 0 ? 0 : red == 255 ? 2 : 1);
    }

    static PixelColor result(const State& state, const ShadeQuad& shaded, unsigned lane) {
        CombineInputs inputs{};
        for (unsigned unit = 0; unit < TextureUnits; ++unit)
            inputs.texture[unit] = (state.sampled_units >> unit & 1) != 0
                                       ? unpack_rgba8(shaded.samples[Lanes * unit + lane])
                                       : UnsampledTexture;
        inputs.primary = unpack_rgba8(shaded.primary[lane]);
        inputs.previous = shaded.quad.rgba(lane);
        return combine(state.combiner, inputs);
    }
    static void
    expect(const State& state, const ShadeQuad& input, std::vector<ShadeQuad>& outputs) {
        ShadeQuad shaded = input;
        for (unsigned lane = 0; lane < Lanes && state.combiner.enable; ++lane)
            shaded.quad.color[lane] = pack_rgba8(result(state, input, lane));
        outputs.push_back(shaded);
    }
};
using Unit = TextureEnvironment;

// Operations of two arguments, on all pairs and scales. Where there are three or four, the others
// are the pair's complements.
TEST_CASE("combiners equal the model's on every pair of arguments, for each operation and scale") {
    TextureEnvironment unit;
    UnitBench<TextureEnvironment> bench(unit);
    const auto state = [](unsigned n) {
        Combiner combiner;
        combiner.enable = true;
        combiner.rgb = combiner.alpha = {
            .op = static_cast<CombineOp>(n >> 2),
            .arguments = {{{CombineSource::Texture0, CombineOperand::Color},
                           {CombineSource::Previous, CombineOperand::Color},
                           {CombineSource::Texture0, CombineOperand::OneMinusColor},
                           {CombineSource::Previous, CombineOperand::OneMinusColor}}},
            .scale_shift = static_cast<std::uint8_t>(n & 3)};
        return TextureEnvironment::State{combiner, 1};
    };
    // Sixteen channels, each with an argument of its own.
    const auto input = [](unsigned, unsigned i) {
        ShadeQuad shaded{.quad = {.live = 0xf}};
        for (unsigned lane = 0; lane < Lanes; ++lane) {
            const unsigned first = 16 * (i % 16) + 4 * lane;
            shaded.samples[lane] = first * 0x01010101u + 0x03020100u;
            shaded.quad.color[lane] = (i / 16) * 0x01010101u;
        }
        return shaded;
    };
    bench.run(counted_source<TextureEnvironment>(13 * 4, 16 * 256, state, input), Stall::Never, 1);
    INFO(bench.report);
    CHECK(bench.mismatches == 0);
    CHECK(bench.compared == 13 * 4 * 16 * 256);
}

} // namespace
} // namespace ffgpu::rtl

#include "tests/rtl/bench/unit_tests.inl"
