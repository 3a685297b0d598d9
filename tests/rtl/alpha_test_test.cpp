// rtl/alpha_test.sv against passes_alpha_test().

#include "Valpha_test.h"
#include "model/fragment/alpha_test.h"
#include "rtl/bundles/quad.h"
#include "rtl/bundles/state.h"
#include "tests/rtl/bench/random_quad.h"
#include "tests/rtl/bench/unit_bench.h"

#include <catch2/catch.hpp>

namespace ffgpu::rtl {
namespace {

struct AlphaTest {
    static constexpr const char* Name = "alpha_test";
    static constexpr std::string_view Latency = "AlphaTestLatency";
    static constexpr std::uint64_t ShortItems = 100000, LongItems = 2500000;

    using Dut = Valpha_test;
    using State = ControlWords;
    using Input = Quad;
    using Output = Quad;

    static void set_tag(Quad& quad, unsigned tag) { quad.tag = tag != 0; }

    static void declare(Bins& bins) {
        bins.declare("enabled", 2);
        bins.declare("comparison: below, equal, above", 8 * 3);
    }
    static void cover(Bins& bins, const State& state, const Quad& quad) {
        const FragmentControl& control = state.control;
        bins.hit("enabled", control.alpha_test);
        for (unsigned lane = 0; lane < Lanes; ++lane) {
            const std::uint8_t alpha = quad.rgba(lane)[3];
            const unsigned side =
                (alpha >= control.alpha_reference) + (alpha > control.alpha_reference ? 1u : 0u);
            bins.hit("comparison: below, equal, above",
                     3 * static_cast<unsigned>(control.alpha_compare) + side);
        }
    }

    static State random_state(Random& random) {
        return {{.color_sum = random.one_in(2),
                 .alpha_test = !random.one_in(8),
                 .alpha_compare = random.any<Compare>(8),
                 .alpha_reference = random.byte(),
                 .dither = random.one_in(2),
                 .count_samples = random.one_in(2)}};
    }
    static Quad random_input(Random& random, const State&) { return random_quad(random); }

    static void expect(const State& state, const Quad& input, std::vector<Quad>& outputs) {
        Quad quad = input;
        for (unsigned lane = 0; lane < Lanes; ++lane)
            if (!passes_alpha_test(state.control, quad.rgba(lane)[3]))
                quad.live &= static_cast<std::uint8_t>(~(1u << lane));
        outputs.push_back(quad);
    }
};
using Unit = AlphaTest;

// Every comparison, reference and alpha, on and off: 2^20 inputs.
TEST_CASE("the alpha test equals the model's on every input") {
    AlphaTest unit;
    UnitBench<AlphaTest> bench(unit);
    const auto state = [](unsigned n) {
        return AlphaTest::State{{.alpha_test = (n & 1) != 0,
                                 .alpha_compare = static_cast<Compare>(n >> 1 & 7),
                                 .alpha_reference = static_cast<std::uint8_t>(n >> 4)}};
    };
    const auto input = [](unsigned, unsigned i) {
        Quad quad{.live = 0xf};
        for (unsigned lane = 0; lane < Lanes; ++lane)
            quad.color[lane] = (Lanes * i + lane) << 24;
        return quad;
    };
    bench.run(counted_source<AlphaTest>(2 * 8 * 256, 64, state, input), Stall::Never, 1);
    INFO(bench.report);
    CHECK(bench.mismatches == 0);
    CHECK(bench.compared == 2 * 8 * 256 * 256 / 4);
}

} // namespace
} // namespace ffgpu::rtl

#include "tests/rtl/bench/unit_tests.inl"
