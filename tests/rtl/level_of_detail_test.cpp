// rtl/level_of_detail.sv against sample_quad().

#include "Vlevel_of_detail.h"
#include "model/texture/level_of_detail.h"
#include "rtl/bundles/levels.h"
#include "tests/rtl/bench/random_texture.h"
#include "tests/rtl/bench/unit_bench.h"

#include <catch2/catch.hpp>

namespace ffgpu::rtl {
namespace {

struct LevelOfDetail {
    static constexpr const char* Name = "level_of_detail";
    static constexpr std::string_view Latency = "LevelOfDetailLatency";
    static constexpr std::uint64_t ShortItems = 300000, LongItems = 10000000;

    using Dut = Vlevel_of_detail;
    using State = TextureWords;
    using Input = LevelQuad;
    using Output = QuadLevels;

    static void set_tag(LevelQuad& quad, unsigned tag) { quad.tag = tag != 0; }
    static State random_state(Random& random) { return random_texture(random); }

    // A footprint of 2^-4 to 2^14 texels, longer one way or the other; or numbers of any size.
    static LevelQuad random_input(Random& random, const State& state) {
        LevelQuad quad{.place = static_cast<std::uint16_t>(random.below(1024)),
                       .one_face = !random.one_in(8)};
        const bool far = random.one_in(16);
        const int size = std::ilogb(static_cast<float>(state.image.shape.width));
        const int across = static_cast<int>(random.below(18)) - 4 - size;
        const int along = random.one_in(2) ? across : across + static_cast<int>(random.below(6));
        for (unsigned axis = 0; axis < 3; ++axis) {
            const float corner = random_number(random, -10, 2);
            const float x = random_number(random, across - 1, across);
            const float y = random_number(random, along - 1, along);
            const std::array<float, 4> lanes{corner, corner + x, corner + y, corner + x + y};
            for (unsigned lane = 0; lane < 4; ++lane)
                quad.coordinates[3 * lane + axis] =
                    far ? random_number(random, -80, 90) : lanes[lane];
        }
        return quad;
    }

    static QuadSampling sampling(const State& state, const LevelQuad& quad) {
        std::array<TexCoord, 4> lanes;
        for (unsigned lane = 0; lane < 4; ++lane)
            lanes[lane] = {quad.coordinates[3 * lane],
                           quad.coordinates[3 * lane + 1],
                           quad.coordinates[3 * lane + 2]};
        return sample_quad(model_unit(state), lanes, quad.one_face);
    }

    static void declare(Bins& bins) {
        bins.declare("kind", 5);
        bins.declare("mip filter", 4);
        bins.declare("probes", MaxProbes);
        bins.declare("level", MaxTextureLevels);
        bins.declare("magnified by the nearest, linearly; minified so", 4);
        bins.declare("magnified up to 0, 1/2", 2);
        bins.declare("longer in x, y", 2);
        bins.declare("lambda at its least, between, greatest", 3);
        bins.declare("step least, between, greatest", 3);
        bins.declare("nearest level from a half", 1);
    }
    static void cover(Bins& bins, const State& state, const LevelQuad& quad) {
        const auto number = [](auto value) { return static_cast<std::size_t>(value); };
        const QuadSampling chosen = sampling(state, quad);
        const TextureUnit unit = model_unit(state);
        const Sampler& sampler = state.sampler;
        bins.hit("kind", number(state.image.shape.kind) - 1);
        bins.hit("mip filter", number(sampler.mip_filter));
        bins.hit("probes", chosen.probes - 1u);
        bins.hit("level", chosen.level);
        const bool minified = chosen.lambda > unit.magnify_limit;
        bins.hit("magnified by the nearest, linearly; minified so",
                 2u * minified + (minified ? sampler.minify_linear : sampler.magnify_linear));
        bins.hit("magnified up to 0, 1/2", unit.magnify_limit != 0);
        bins.hit("longer in x, y", chosen.footprint.x < chosen.footprint.y);
        bins.hit("lambda at its least, between, greatest",
                 chosen.lambda == sampler.max_lod   ? 2
                 : chosen.lambda == sampler.min_lod ? 0
                                                    : 1);
        const float texels = std::abs(chosen.steps.x[0] * unit.density[0]);
        bins.hit("step least, between, greatest",
                 texels < LeastStep     ? 0
                 : texels > LargestStep ? 2
                                        : 1);
        if (minified && sampler.mip_filter == MipFilter::Nearest && (chosen.lambda & 255) == 128)
            bins.hit("nearest level from a half", 0);
    }

    static void expect(const State& state, const LevelQuad& quad, std::vector<Output>& outputs) {
        const QuadSampling chosen = sampling(state, quad);
        outputs.push_back({quad.tag,
                           quad.place,
                           chosen.level,
                           chosen.next_level,
                           chosen.weight,
                           chosen.linear,
                           chosen.probes,
                           {chosen.major_step.s, chosen.major_step.t, chosen.major_step.r}});
    }
};
using Unit = LevelOfDetail;

TextureWords one_texel() {
    TextureWords words;
    words.image.shape = {.kind = TextureKind::OneD,
                         .format = Format::Luminance8,
                         .width = 1,
                         .height = 1,
                         .depth = 1,
                         .levels = MaxTextureLevels};
    return words;
}

// Of one texel's density the squared length's exponent and leading bits are the step's, squared:
// all entries of the table are met.
TEST_CASE("logarithms equal the model's from every entry of the table") {
    LevelOfDetail unit;
    UnitBench<LevelOfDetail> bench(unit);
    const auto state = [](unsigned) { return one_texel(); };
    const auto input = [](unsigned n, unsigned i) {
        LevelQuad quad;
        quad.coordinates[3] = std::sqrt(1 + static_cast<float>(i) / 1024) * std::ldexp(1.0f, 4);
        quad.coordinates[6] = std::ldexp(1.0f, static_cast<int>(n));
        return quad;
    };
    bench.run(counted_source<LevelOfDetail>(6, 1024, state, input), Stall::Never, 1);
    INFO(bench.report);
    CHECK(bench.mismatches == 0);
    CHECK(bench.compared == 6 * 1024);
}

// Lambda is the bias plus 256 for each doubling of the step.
TEST_CASE("lambda is held to a least and a greatest one that are a step away from it") {
    LevelOfDetail unit;
    UnitBench<LevelOfDetail> bench(unit);
    const auto state = [](unsigned n) {
        TextureWords words = one_texel();
        words.sampler.minify_linear = true;
        words.sampler.mip_filter = MipFilter::Linear;
        words.sampler.bias = static_cast<std::int16_t>(n % 2 + 130);
        const auto bound = static_cast<std::int16_t>(4 * 256 + words.sampler.bias +
                                                     static_cast<int>(n / 2 % 5) - 2);
        (n / 10 == 0 ? words.sampler.min_lod : words.sampler.max_lod) = bound;
        return words;
    };
    const auto input = [](unsigned, unsigned i) {
        LevelQuad quad;
        quad.coordinates[3] = std::ldexp(1.0f, static_cast<int>(i) + 3);
        return quad;
    };
    bench.run(counted_source<LevelOfDetail>(20, 3, state, input), Stall::Never, 1);
    INFO(bench.report);
    CHECK(bench.mismatches == 0);
    CHECK(bench.compared == 20 * 3);
}

} // namespace
} // namespace ffgpu::rtl

#include "tests/rtl/bench/unit_tests.inl"
