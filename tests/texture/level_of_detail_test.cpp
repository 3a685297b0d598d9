// Level of detail on planes whose answer is known, and the edges of the choice of level.

#include "model/texture/level_of_detail.h"
#include "tests/texture/texture_fixture.h"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

namespace ffgpu::test {
namespace {

struct Slopes {
    double s_x, t_x, s_y, t_y; // texels a pixel
};

TextureUnit make_unit(Sampler sampler, std::uint32_t width = 256, std::uint32_t height = 256) {
    static std::vector<TextureMemory> keep; // Units point into their memory.
    keep.emplace_back(TextureShape{TextureKind::TwoD, Format::Rgba8, width, height, 1, 9, 0});
    return keep.back().compile(sampler);
}

QuadSampling sample_slopes(const TextureUnit& unit, const Slopes& slopes) {
    std::array<TexCoord, 4> lanes;
    for (unsigned i = 0; i < 4; ++i) {
        const double x = i % 2, y = i / 2;
        lanes[i].s = static_cast<float>((slopes.s_x * x + slopes.s_y * y) / unit.size[0]);
        lanes[i].t = static_cast<float>((slopes.t_x * x + slopes.t_y * y) / unit.size[1]);
    }
    return sample_quad(unit, lanes, true);
}

double detail(const QuadSampling& quad) {
    return quad.level + quad.weight / 256.0;
}

Sampler trilinear() {
    Sampler sampler = linear_sampler();
    sampler.mip_filter = MipFilter::Linear;
    return sampler;
}

TEST_CASE("a uniform scale of 2^f has level of detail f") {
    const TextureUnit unit = make_unit(trilinear());
    for (int i = 1; i < 8 * 16; ++i) {
        const double f = i / 16.0, scale = std::exp2(f);
        const QuadSampling quad = sample_slopes(unit, {scale, 0, 0, scale});
        if (i % 16 == 0) CHECK(detail(quad) == f); // Powers of two are exact.
        CHECK(detail(quad) <= f);
        CHECK(detail(quad) > f - 2.5 / 256);
    }
}

TEST_CASE("a rotated plane has the level of its longer side, not of its projections") {
    const TextureUnit unit = make_unit(trilinear(), 256, 128);
    for (int degrees = 0; degrees < 360; degrees += 7) {
        const double c = std::cos(degrees * 3.14159265358979 / 180) * 4;
        const double s = std::sin(degrees * 3.14159265358979 / 180) * 4;
        const QuadSampling quad = sample_slopes(unit, {c, s, -s, c});
        CHECK(std::abs(detail(quad) - 2) < 3.0 / 256);
    }
    CHECK(std::abs(detail(sample_slopes(unit, {8, 0, 0, 2})) - 3) < 0.001);
    CHECK(std::abs(detail(sample_slopes(unit, {0, 2, 8, 8})) - 3.5) < 0.01);
}

TEST_CASE("bias is added before the clamps to the level of detail's range") {
    Sampler sampler = trilinear();
    sampler.bias = 128;
    CHECK(detail(sample_slopes(make_unit(sampler), {4, 0, 0, 4})) == 2.5);
    sampler.max_lod = 512;
    CHECK(detail(sample_slopes(make_unit(sampler), {4, 0, 0, 4})) == 2);
    sampler.min_lod = 3 * 256 + 64;
    sampler.max_lod = 8 * 256;
    CHECK(detail(sample_slopes(make_unit(sampler), {4, 0, 0, 4})) == 3.25);
    sampler.max_level = 2;
    const QuadSampling quad = sample_slopes(make_unit(sampler), {4, 0, 0, 4});
    CHECK(quad.level == 2);
    CHECK(quad.weight == 0);
}

TEST_CASE("the nearest level is ceil(lambda + 1/2) - 1: halves go to the finer one") {
    Sampler sampler = nearest_sampler();
    sampler.mip_filter = MipFilter::Nearest;
    const TextureUnit unit = make_unit(sampler);
    for (int lambda = 1; lambda < 3000; ++lambda) {
        const int expected = static_cast<int>(std::ceil(lambda / 256.0 + 0.5)) - 1;
        REQUIRE(choose_levels(unit, lambda).level == std::min(expected, 8));
    }
    CHECK(choose_levels(unit, 128).level == 0);
    CHECK(choose_levels(unit, 129).level == 1);
    CHECK(choose_levels(unit, 384).level == 1);
    CHECK(choose_levels(unit, 385).level == 2);
}

TEST_CASE("linear mips take floor(lambda) and its fraction, and the last level alone at the end") {
    const TextureUnit unit = make_unit(trilinear());
    for (const int lambda : {1, 255, 256, 257, 511, 2047}) {
        const QuadSampling quad = choose_levels(unit, lambda);
        CHECK(quad.level == lambda / 256);
        CHECK(quad.next_level == lambda / 256 + 1);
        CHECK(quad.weight == lambda % 256);
    }
    CHECK(choose_levels(unit, 2048).weight == 0);
    CHECK(choose_levels(unit, 2049).level == 8);
    CHECK(choose_levels(unit, 2049).weight == 0);
}

TEST_CASE("magnification ends at 0, or at 1/2 where only magnifying is linear within a level") {
    Sampler sampler = trilinear();
    sampler.minify_linear = false;
    for (const MipFilter mip : {MipFilter::None, MipFilter::Nearest, MipFilter::Linear}) {
        sampler.mip_filter = mip;
        const int limit = mip == MipFilter::None ? 0 : 128;
        const TextureUnit unit = make_unit(sampler);
        CHECK(choose_levels(unit, limit).linear);
        CHECK_FALSE(choose_levels(unit, limit + 1).linear);
    }
    sampler.magnify_linear = false;
    sampler.minify_linear = true;
    const TextureUnit unit = make_unit(sampler);
    CHECK_FALSE(choose_levels(unit, 0).linear);
    CHECK(choose_levels(unit, 1).linear);
}

TEST_CASE("anisotropic probes divide the longer side until it is no longer than the shorter") {
    Sampler sampler = trilinear();
    sampler.max_anisotropy = 16;
    const TextureUnit unit = make_unit(sampler);
    CHECK(sample_slopes(unit, {8, 0, 0, 2}).probes == 4);
    CHECK(detail(sample_slopes(unit, {8, 0, 0, 2})) == 1);
    CHECK(sample_slopes(unit, {2, 0, 0, 2}).probes == 1);
    CHECK(sample_slopes(unit, {9, 0, 0, 2}).probes == 5);
    CHECK(sample_slopes(unit, {200, 0, 0, 1}).probes == 16);
    CHECK(sample_slopes(unit, {0.5, 0, 0, 0.1}).probes == 1); // Magnified: one is enough.
    CHECK(sample_slopes(unit, {3, 0, 0, 0.1}).probes == 3);
    CHECK(sample_slopes(unit, {1, 0, 0, 8}).major_step.t == 8.0f / 256);
    sampler.max_anisotropy = 2;
    CHECK(sample_slopes(make_unit(sampler), {8, 0, 0, 1}).probes == 2);
    CHECK(detail(sample_slopes(make_unit(sampler), {8, 0, 0, 1})) == 2);
}

TEST_CASE("the longest steps give the coarsest level, the shortest the finest") {
    const TextureUnit unit = make_unit(trilinear());
    CHECK(sample_slopes(unit, {0x1p110, 0, 0, 0}).level == 8);
    CHECK(sample_slopes(unit, {0x1p110, 0x1p110, 0x1p110, 0x1p110}).level == 8);
    CHECK(sample_slopes(unit, {0x1p-100, 0, 0, 0}).level == 0);
    CHECK(sample_slopes(unit, {0, 0, 0, 0}).level == 0);
}

// 512 log2(n) in long double, rounded down: what the table of the probes has to be.
TEST_CASE("n probes take log2(n) off the level of detail") {
    for (unsigned n = 1; n <= MaxProbes; ++n)
        CHECK(ProbeLogarithms[n] ==
              static_cast<int>(std::floor(512 * std::log2(static_cast<long double>(n)))));
}

} // namespace
} // namespace ffgpu::test
