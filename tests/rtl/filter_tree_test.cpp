// rtl/filter_tree.sv against lerp8w(), level by level and probe by probe.

#include "Vfilter_tree.h"
#include "model/memory/pixel_format.h"
#include "model/texture/filter.h"
#include "rtl/bundles/quad.h"
#include "rtl/bundles/texel.h"
#include "tests/rtl/bench/random_quad.h"
#include "tests/rtl/bench/unit_bench.h"

#include <catch2/catch.hpp>

namespace ffgpu::rtl {
namespace {

struct FilterTree {
    static constexpr const char* Name = "filter_tree";
    static constexpr std::string_view Latency = "FilterTreeLatency";
    static constexpr std::uint64_t ShortItems = 1000000, LongItems = 10000000;

    using Dut = Vfilter_tree;
    using State = NoState;
    using Input = FilterLevel;
    using Output = Texel;

    static void set_tag(FilterLevel& level, unsigned tag) { level.tag = tag != 0; }
    static State random_state(Random&) { return {}; }

    // Fragments whole: `left_` levels of the present one are still to come.
    FilterLevel random_input(Random& random, const State&) {
        if (left_ == 0) {
            probes_ = random.one_in(2) ? 1 : 1 + random.below(16);
            levels_ = 1 + random.below(2);
            left_ = probes_ * levels_;
        }
        --left_;
        FilterLevel level{.place = static_cast<std::uint16_t>(random.below(1024)),
                          .last_level = left_ % levels_ == 0,
                          .last_probe = left_ < levels_,
                          .probes = static_cast<std::uint8_t>(probes_),
                          .level_weight = random.byte(),
                          .weight_z = random.byte(),
                          .weight_y = random.byte(),
                          .weight_x = random.byte()};
        for (std::uint32_t& texel : level.texels)
            texel = random_color(random);
        return level;
    }

    void declare(Bins& bins) const {
        bins.declare("probes", 17);
        bins.declare("levels", 3);
        bins.declare("weight x 0", 2);
        bins.declare("weight y 0", 2);
        bins.declare("weight z 0", 2);
        bins.declare("lerp: remainder below, at, above the half", 3);
        bins.hit("probes", 0); // There is none with 0.
        bins.hit("levels", 0);
    }
    void cover(Bins& bins, const State&, const FilterLevel& level) const {
        bins.hit("probes", level.probes);
        bins.hit("levels", levels_);
        bins.hit("weight x 0", level.weight_x == 0);
        bins.hit("weight y 0", level.weight_y == 0);
        bins.hit("weight z 0", level.weight_z == 0);
        const unsigned a = level.texels[0] & 255, b = level.texels[1] & 255;
        const unsigned fraction = (a * (256u - level.weight_x) + b * level.weight_x) & 255;
        bins.hit("lerp: remainder below, at, above the half",
                 fraction < 128    ? 0
                 : fraction == 128 ? 1
                                   : 2);
    }

    static Rgba filtered(const FilterLevel& level) {
        std::array<Rgba, 8> colors{};
        for (unsigned i = 0; i < 8; ++i)
            colors[i] = unpack_rgba8(level.texels[i]);
        const auto slice = [&](unsigned z) {
            const Rgba near = lerp8w(colors[4 * z], colors[4 * z + 1], level.weight_x);
            const Rgba far = lerp8w(colors[4 * z + 2], colors[4 * z + 3], level.weight_x);
            return lerp8w(near, far, level.weight_y);
        };
        return lerp8w(slice(0), slice(1), level.weight_z);
    }
    void expect(const State&, const FilterLevel& level, std::vector<Texel>& outputs) {
        const Rgba color = filtered(level);
        if (!level.last_level) {
            fine_ = color;
            return;
        }
        const Rgba probe = lerp8w(fine_.value_or(color), color, level.level_weight);
        fine_.reset();
        for (unsigned channel = 0; channel < 4; ++channel)
            sum_[channel] += probe[channel];
        if (!level.last_probe) return;
        Rgba mean{};
        for (unsigned channel = 0; channel < 4; ++channel)
            mean[channel] =
                static_cast<std::uint8_t>((sum_[channel] + level.probes / 2u) / level.probes);
        sum_ = {};
        outputs.push_back({level.tag, level.place, pack_rgba8(mean)});
    }
    // A fragment that a reset cuts in two goes on with whole ones.
    void reset() {
        fine_.reset();
        sum_ = {};
        left_ = 0;
    }

private:
    unsigned left_ = 0, probes_ = 1, levels_ = 1;
    std::optional<Rgba> fine_;
    std::array<unsigned, 4> sum_{};
};
using Unit = FilterTree;

// A lerp of every two channels with every weight: 2^24 inputs, in the long form; every eighth
// weight in the short one. Each axis takes a share of the weights.
TEST_CASE("lerps equal the model's on every input") {
    FilterTree unit;
    UnitBench<FilterTree> bench(unit);
    const unsigned step = std::getenv("FFGPU_RTL_LONG") ? 1 : 8;
    const auto state = [](unsigned) { return NoState{}; };
    const auto input = [step](unsigned n, unsigned i) {
        const std::uint32_t a = (i & 63) * 0x04040404u + 0x03020100u;
        const std::uint32_t b = (i >> 6) * 0x01010101u;
        const auto weight = static_cast<std::uint8_t>(n * step);
        FilterLevel level{.place = static_cast<std::uint16_t>(i & 1023)};
        if (n % 3 == 0) {
            level.weight_x = weight;
            level.texels = {a, b, a, b, a, b, a, b};
        } else if (n % 3 == 1) {
            level.weight_y = weight;
            level.texels = {a, a, b, b, a, a, b, b};
        } else {
            level.weight_z = weight;
            level.texels = {a, a, a, a, b, b, b, b};
        }
        return level;
    };
    bench.run(counted_source<FilterTree>(256 / step, 64 * 256, state, input), Stall::Never, 1);
    INFO(bench.report);
    CHECK(bench.mismatches == 0);
    CHECK(bench.compared == 256 / step * 64 * 256);
}

// Of n probes that are (sum + i) / n rounded down, i = 0 .. n-1, the sum is that (Hermite). Each
// channel has a sum of its own.
TEST_CASE("means equal the model's of every sum of every count of probes") {
    FilterTree unit;
    UnitBench<FilterTree> bench(unit);
    std::vector<FilterLevel> levels;
    unsigned fragments = 0;
    for (unsigned count = 1; count <= 16; ++count)
        for (unsigned sum = 0; sum <= 255 * count; sum += 4, ++fragments)
            for (unsigned probe = 0; probe < count; ++probe) {
                const auto share = [&](unsigned channel) {
                    const unsigned own = std::min(sum + channel, 255 * count);
                    return static_cast<std::uint8_t>((own + probe) / count);
                };
                FilterLevel level{.place = static_cast<std::uint16_t>(fragments & 1023),
                                  .last_level = true,
                                  .last_probe = probe + 1 == count,
                                  .probes = static_cast<std::uint8_t>(count)};
                level.texels.fill(pack_rgba8({share(0), share(1), share(2), share(3)}));
                levels.push_back(level);
            }
    const auto state = [](unsigned) { return NoState{}; };
    const auto input = [&](unsigned, unsigned i) { return levels[i]; };
    const auto count = static_cast<unsigned>(levels.size());
    bench.run(counted_source<FilterTree>(1, count, state, input), Stall::Never, 1);
    INFO(bench.report);
    CHECK(bench.mismatches == 0);
    CHECK(bench.compared == fragments);
}

} // namespace
} // namespace ffgpu::rtl

#include "tests/rtl/bench/unit_tests.inl"
