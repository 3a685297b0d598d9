// rtl/fog.sv against fog_factor() and apply_fog().

#include "Vfog.h"
#include "model/arith/range.h"
#include "model/fragment/fog.h"
#include "rtl/bundles/quad.h"
#include "rtl/bundles/state.h"
#include "tests/rtl/bench/random_quad.h"
#include "tests/rtl/bench/unit_bench.h"

#include <catch2/catch.hpp>

namespace ffgpu::rtl {
namespace {

struct FogUnit {
    static constexpr const char* Name = "fog";
    static constexpr std::string_view Latency = "FogLatency";
    static constexpr std::uint64_t ShortItems = 150000, LongItems = 2500000;

    using Dut = Vfog;
    using State = FogWords;
    using Input = ShadeQuad;
    using Output = Quad;

    static void set_tag(ShadeQuad& shaded, unsigned tag) { shaded.quad.tag = tag != 0; }

    // Any mantissa, a sign, exponents from `least` to `most`.
    static float random_float(Random& random, int least, int most) {
        const auto exponent = static_cast<std::uint32_t>(127 + least) +
                              random.below(static_cast<std::uint32_t>(most - least + 1));
        return std::bit_cast<float>((random.one_in(4) ? 0x80000000u : 0u) | exponent << 23 |
                                    random.word() >> 9);
    }
    static float random_any(Random& random) {
        if (random.one_in(20)) return 0;
        const bool far = random.one_in(4);
        return in_fog_range(far ? random_float(random, -40, 40) : random_float(random, -4, 8));
    }
    static State random_state(Random& random) {
        Fog fog{.mode = random.any<FogMode>(4),
                .color = random_color(random) & 0xffffff,
                .density = random.one_in(4) ? random_any(random) : random_float(random, -6, 0),
                .start = random_any(random),
                .end = random_any(random)};
        if (random.one_in(10)) fog.end = fog.start;
        return {compile_fog(fog)};
    }
    static ShadeQuad random_input(Random& random, const State& state) {
        ShadeQuad shaded = random_shade_quad(random);
        for (float& coordinate : shaded.fog_coordinate) {
            coordinate = random_any(random);
            // Between start and end, and at the end itself.
            if (state.curve.mode == FogMode::Linear && random.one_in(2))
                coordinate = in_fog_range(state.curve.end - static_cast<float>(random.below(300)) /
                                                                256.0f / state.curve.scale);
        }
        return shaded;
    }

    static void declare(Bins& bins) {
        bins.declare("mode and factor none, some, all", 4 * 3);
        bins.declare("coordinate sign, zero", 3);
    }
    static void cover(Bins& bins, const State& state, const ShadeQuad& shaded) {
        for (const float coordinate : shaded.fog_coordinate) {
            bins.hit("coordinate sign, zero", coordinate < 0 ? 0 : coordinate > 0 ? 1 : 2);
            const unsigned factor =
                state.curve.mode == FogMode::Off ? 128 : fog_factor(state.curve, coordinate);
            const std::size_t mode = 3 * static_cast<std::size_t>(state.curve.mode);
            bins.hit("mode and factor none, some, all",
                     mode + (factor == 0     ? 0u
                             : factor == 255 ? 2u
                                             : 1u));
            if (state.curve.mode == FogMode::Off) { // There the factor is of no matter.
                bins.hit("mode and factor none, some, all", 0);
                bins.hit("mode and factor none, some, all", 2);
            }
        }
    }

    static void expect(const State& state, const ShadeQuad& input, std::vector<Quad>& outputs) {
        Quad quad = input.quad;
        for (unsigned lane = 0; lane < Lanes && state.curve.mode != FogMode::Off; ++lane) {
            const std::uint8_t factor = fog_factor(state.curve, input.fog_coordinate[lane]);
            quad.color[lane] = pack_rgba8(apply_fog(state.curve, factor, quad.rgba(lane)));
        }
        outputs.push_back(quad);
    }
};
using Unit = FogUnit;

// x = c k with k = 1 is any number of 16 fraction bits below the limit of 11.5, and some beyond it.
TEST_CASE("the fog table equals the model's on every fixed-point exponent") {
    FogUnit unit;
    UnitBench<FogUnit> bench(unit);
    constexpr unsigned Items = 12 * 65536 / 4;
    const auto state = [](unsigned) {
        return FogUnit::State{{.mode = FogMode::Exp, .scale = 1, .color = {0, 255, 0, 0}}};
    };
    const auto input = [](unsigned, unsigned i) {
        ShadeQuad shaded{.quad = {.live = 0xf}};
        for (unsigned lane = 0; lane < Lanes; ++lane) {
            shaded.fog_coordinate[lane] = static_cast<float>(Lanes * i + lane) / 65536.0f;
            shaded.quad.color[lane] = 0xff;
        }
        return shaded;
    };
    bench.run(counted_source<FogUnit>(1, Items, state, input), Stall::Never, 1);
    INFO(bench.report);
    CHECK(bench.mismatches == 0);
    CHECK(bench.compared == Items);
}

// The last coordinate whose factor is at least this one, of a curve that falls; a small one where
// there is none.
float last_with(const FogCurve& curve, unsigned factor) {
    std::uint32_t first = std::bit_cast<std::uint32_t>(0x1p-20f);
    std::uint32_t last = std::bit_cast<std::uint32_t>(64.0f);
    while (last - first > 1) {
        const std::uint32_t middle = first + (last - first) / 2;
        (fog_factor(curve, std::bit_cast<float>(middle)) >= factor ? first : last) = middle;
    }
    return std::bit_cast<float>(first);
}

// Where a constant of the curve is wrong in its last bit some factor begins or ends too early.
TEST_CASE("the fog factor steps at the model's coordinates") {
    FogUnit unit;
    UnitBench<FogUnit> bench(unit);
    constexpr std::array Modes{FogMode::Exp, FogMode::Exp2, FogMode::Linear};
    constexpr std::array Scales{1.0f, 0.7f, 1.9f, 0.3f};
    const auto state = [&](unsigned n) {
        return FogUnit::State{{.mode = Modes[n / Scales.size()],
                               .end = 1,
                               .scale = Scales[n % Scales.size()],
                               .color = {0, 255, 0, 0}}};
    };
    const auto input = [&](unsigned n, unsigned i) {
        ShadeQuad shaded{.quad = {.live = 0xf}};
        const std::uint32_t step = std::bit_cast<std::uint32_t>(last_with(state(n).curve, i + 1));
        for (unsigned lane = 0; lane < Lanes; ++lane) {
            shaded.fog_coordinate[lane] = std::bit_cast<float>(step + lane - 1);
            shaded.quad.color[lane] = 0xff;
        }
        return shaded;
    };
    constexpr auto States = static_cast<unsigned>(Modes.size() * Scales.size());
    bench.run(counted_source<FogUnit>(States, 255, state, input), Stall::Never, 1);
    INFO(bench.report);
    CHECK(bench.mismatches == 0);
    CHECK(bench.compared == States * 255);
}

// Of every factor, colour and fog colour: 2^24 inputs in the long form, of the short one each
// eighth fog colour. Linear with end 1 and k 1: a coordinate of (255 - F) / 255 has the factor F.
TEST_CASE("the fogged colour equals the model's on every factor, colour and fog colour") {
    FogUnit unit;
    UnitBench<FogUnit> bench(unit);
    const unsigned step = std::getenv("FFGPU_RTL_LONG") ? 1 : 8;
    const auto state = [step](unsigned n) {
        const auto fog = static_cast<std::uint8_t>(n * step);
        return FogUnit::State{
            {.mode = FogMode::Linear, .end = 1, .scale = 1, .color = {fog, fog, fog, 0}}};
    };
    const auto input = [](unsigned, unsigned i) {
        ShadeQuad shaded{.quad = {.live = 0xf}};
        const unsigned factor = i / 22;
        for (unsigned lane = 0; lane < Lanes; ++lane) {
            shaded.fog_coordinate[lane] = static_cast<float>(255 - factor) / 255.0f;
            for (unsigned channel = 0; channel < 3; ++channel)
                shaded.quad.color[lane] |= std::min(12 * (i % 22) + 3 * lane + channel, 255u)
                                           << 8 * channel;
        }
        return shaded;
    };
    bench.run(counted_source<FogUnit>(256 / step, 22 * 256, state, input), Stall::Never, 1);
    INFO(bench.report);
    CHECK(bench.mismatches == 0);
    CHECK(bench.compared == 256 / step * 22 * 256);
}

} // namespace
} // namespace ffgpu::rtl

#include "tests/rtl/bench/unit_tests.inl"
