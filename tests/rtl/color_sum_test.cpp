// rtl/color_sum.sv against add_secondary().

#include "Vcolor_sum.h"
#include "model/fragment/color_sum.h"
#include "rtl/bundles/quad.h"
#include "rtl/bundles/state.h"
#include "tests/rtl/bench/random_quad.h"
#include "tests/rtl/bench/unit_bench.h"

#include <catch2/catch.hpp>

namespace ffgpu::rtl {
namespace {

struct ColorSum {
    static constexpr const char* Name = "color_sum";
    static constexpr std::string_view Latency = "ColorSumLatency";
    static constexpr std::uint64_t ShortItems = 100000, LongItems = 2500000;

    using Dut = Vcolor_sum;
    using State = ControlWords;
    using Input = ShadeQuad;
    using Output = ShadeQuad;

    static void set_tag(ShadeQuad& shaded, unsigned tag) { shaded.quad.tag = tag != 0; }

    static void declare(Bins& bins) { bins.declare("off, sum, clamped sum", 3); }
    static void cover(Bins& bins, const State& state, const ShadeQuad& shaded) {
        const unsigned sum = shaded.quad.rgba(0)[0] + (shaded.secondary[0] & 255);
        bins.hit("off, sum, clamped sum", !state.control.color_sum ? 0 : sum <= 255 ? 1 : 2);
    }

    static State random_state(Random& random) {
        return {{.color_sum = !random.one_in(4), .alpha_test = random.one_in(2)}};
    }
    static ShadeQuad random_input(Random& random, const State&) {
        return random_shade_quad(random);
    }

    static void
    expect(const State& state, const ShadeQuad& input, std::vector<ShadeQuad>& outputs) {
        ShadeQuad shaded = input;
        for (unsigned lane = 0; lane < Lanes && state.control.color_sum; ++lane)
            shaded.quad.color[lane] = pack_rgba8(
                add_secondary(shaded.quad.rgba(lane), unpack_rgba8(shaded.secondary[lane])));
        outputs.push_back(shaded);
    }
};
using Unit = ColorSum;

// A lane and channel each has its share of the pairs: 12 channels meet all 2^16.
TEST_CASE("the colour sum equals the model's on every pair of channels") {
    ColorSum unit;
    UnitBench<ColorSum> bench(unit);
    const auto state = [](unsigned) { return ColorSum::State{{.color_sum = true}}; };
    const auto input = [](unsigned a, unsigned b) {
        ShadeQuad shaded{.quad = {.live = 0xf}};
        for (unsigned lane = 0; lane < Lanes; ++lane) {
            shaded.quad.color[lane] = a * 0x01010101u;
            shaded.secondary[lane] = b * 0x010101u;
        }
        return shaded;
    };
    bench.run(counted_source<ColorSum>(256, 256, state, input), Stall::Never, 1);
    INFO(bench.report);
    CHECK(bench.mismatches == 0);
    CHECK(bench.compared == 1 << 16);
}

} // namespace
} // namespace ffgpu::rtl

#include "tests/rtl/bench/unit_tests.inl"
