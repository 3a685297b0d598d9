// rtl/apply_coverage.sv against apply_coverage().

#include "Vapply_coverage.h"
#include "model/fragment/color_sum.h"
#include "rtl/bundles/quad.h"
#include "tests/rtl/bench/random_quad.h"
#include "tests/rtl/bench/unit_bench.h"

#include <catch2/catch.hpp>

namespace ffgpu::rtl {
namespace {

struct ApplyCoverage {
    static constexpr const char* Name = "apply_coverage";
    static constexpr std::string_view Latency = "ApplyCoverageLatency";
    static constexpr std::uint64_t ShortItems = 100000, LongItems = 2500000;

    using Dut = Vapply_coverage;
    using State = NoState;
    using Input = Quad;
    using Output = Quad;

    static void set_tag(Quad& quad, unsigned tag) { quad.tag = tag != 0; }

    static void declare(Bins& bins) { bins.declare("coverage none, some, all", 3); }
    static void cover(Bins& bins, const State&, const Quad& quad) {
        for (const std::uint8_t coverage : quad.coverage)
            bins.hit("coverage none, some, all", coverage == 0 ? 0 : coverage == 255 ? 2 : 1);
    }

    static State random_state(Random&) { return {}; }
    static Quad random_input(Random& random, const State&) { return random_quad(random); }

    static void expect(const State&, const Quad& input, std::vector<Quad>& outputs) {
        Quad quad = input;
        for (unsigned lane = 0; lane < Lanes; ++lane)
            quad.color[lane] = pack_rgba8(apply_coverage(quad.rgba(lane), quad.coverage[lane]));
        outputs.push_back(quad);
    }
};
using Unit = ApplyCoverage;

TEST_CASE("coverage times alpha equals the model's on every pair, in every lane") {
    ApplyCoverage unit;
    UnitBench<ApplyCoverage> bench(unit);
    const auto state = [](unsigned) { return NoState{}; };
    const auto input = [](unsigned alpha, unsigned coverage) {
        Quad quad{.live = 0xf};
        for (unsigned lane = 0; lane < Lanes; ++lane) {
            quad.color[lane] = alpha << 24;
            quad.coverage[lane] = static_cast<std::uint8_t>(coverage);
        }
        return quad;
    };
    bench.run(counted_source<ApplyCoverage>(256, 256, state, input), Stall::Never, 1);
    INFO(bench.report);
    CHECK(bench.mismatches == 0);
    CHECK(bench.compared == 1 << 16);
}

} // namespace
} // namespace ffgpu::rtl

#include "tests/rtl/bench/unit_tests.inl"
