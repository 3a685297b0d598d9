// Anisotropic filtering: where the probes stand, and what their mean is.

#include "model/texture/coordinates.h"
#include "tests/texture/texture_fixture.h"

#include <cmath>

#include <catch2/catch.hpp>

namespace ffgpu::test {
namespace {

// Columns alternate between 0 and 200.
TextureMemory stripes() {
    TextureMemory memory({TextureKind::TwoD, Format::Luminance8, 64, 64, 1, 1, 0});
    for (unsigned y = 0; y < 64; ++y)
        for (unsigned x = 0; x < 64; ++x)
            *memory.at(0, 0, x, y) = std::byte(x % 2 * 200);
    return memory;
}

// One quad around (s, t) that steps by `texels_x` along s for a pixel in x, by one texel in y.
ColorPlanes sample_stretched(const TextureUnit& unit, float texels_x, TexelFootprints* footprints) {
    const auto planes = make_planes(1, [&](unsigned lane) {
        const auto x = static_cast<float>(lane % 2), y = static_cast<float>(lane / 2);
        return Coordinates{(16.5f + x * texels_x) / 64, (16.5f + y) / 64};
    });
    ColorPlanes out;
    sample(unit, *planes, all_quads(1), out, footprints);
    return out;
}

Sampler anisotropic(unsigned most) {
    Sampler sampler = linear_sampler();
    sampler.max_anisotropy = static_cast<std::uint8_t>(most);
    return sampler;
}

TEST_CASE("probes stand in the middles of n equal parts of the longer side") {
    CHECK(probe_position(1, 1) == 0);
    CHECK(probe_position(1, 2) == -0.25f);
    CHECK(probe_position(2, 2) == 0.25f);
    CHECK(probe_position(1, 4) == -0.375f);
    CHECK(probe_position(2, 4) == -0.125f);
    for (unsigned i = 1; i <= 16; ++i)
        CHECK(std::abs(probe_position(i, 16) + probe_position(17 - i, 16)) < 1e-6f);
    CHECK(move_to_probe(3, 1e20f, 0) == 3);
}

TEST_CASE("the mean of the probes shows the stretched side's texels, one probe does not") {
    const TextureMemory memory = stripes();
    CHECK(color_of(sample_stretched(memory.compile(anisotropic(1)), 8, nullptr), 0)[0] == 0);
    // Seven probes a texel apart, the first at -3: 3 of them on a bright column or, at the odd
    // lane's place too, which stands 7 texels on.
    const unsigned mean =
        color_of(sample_stretched(memory.compile(anisotropic(7)), 7, nullptr), 0)[0];
    CHECK(mean == (4 * 200 + 3) / 7);
}

TEST_CASE("every probe is an access, in order along the longer side") {
    const TextureMemory memory = stripes();
    TexelFootprints footprints;
    sample_stretched(memory.compile(anisotropic(7)), 7, &footprints);
    REQUIRE(footprints.accesses().size() == 4 * 7);
    for (unsigned i = 0; i < 7; ++i) {
        CHECK(footprints.accesses()[i].lane == 0);
        CHECK(footprints.accesses()[i].x0 == 13 + i);
        CHECK(footprints.accesses()[i].y0 == 16);
    }
}

// Squares of 4x4 texels, black or white, as text and edges are; each level the mean of four.
TextureMemory squares(std::uint32_t seed) {
    constexpr unsigned Levels = 8;
    TextureMemory memory({TextureKind::TwoD, Format::Luminance8, 128, 128, 1, Levels, 0});
    Random random(seed);
    for (unsigned y = 0; y < 128; ++y)
        for (unsigned x = 0; x < 128; ++x)
            *memory.at(0, 0, x, y) = y % 4 != 0   ? *memory.at(0, 0, x, y - 1)
                                     : x % 4 != 0 ? *memory.at(0, 0, x - 1, y)
                                                  : std::byte(below(random, 2) * 255);
    for (unsigned level = 1; level < Levels; ++level)
        for (unsigned y = 0; y < 128u >> level; ++y)
            for (unsigned x = 0; x < 128u >> level; ++x) {
                unsigned sum = 2;
                for (unsigned i = 0; i < 4; ++i)
                    sum += std::to_integer<unsigned>(
                        *memory.at(level - 1, 0, 2 * x + i % 2, 2 * y + i / 2));
                *memory.at(level, 0, x, y) = std::byte(sum / 4);
            }
    return memory;
}

// A pixel's parallelogram in texels of level 0.
struct Footprint {
    double s, t, long_s, long_t, short_s, short_t;
};

// The mean of the texels' squares over it.
double area_mean(TextureMemory& memory, const Footprint& pixel) {
    constexpr int Steps = 32;
    double sum = 0;
    for (int i = 0; i < Steps * Steps; ++i) {
        const double a = (i % Steps + 0.5) / Steps - 0.5;
        const double b = (std::floor(i / double{Steps}) + 0.5) / Steps - 0.5;
        const auto texel = [](double at) {
            return static_cast<unsigned>(static_cast<int>(std::floor(at)) & 127);
        };
        sum +=
            std::to_integer<int>(*memory.at(0,
                                            0,
                                            texel(pixel.s + a * pixel.long_s + b * pixel.short_s),
                                            texel(pixel.t + a * pixel.long_t + b * pixel.short_t)));
    }
    return sum / (Steps * Steps);
}

// Root mean square distance from the mean over the footprint, `ratio` texels long and one wide.
double error_against_area(unsigned most_probes, double ratio) {
    constexpr int Pixels = 300;
    constexpr double Angle = 0.3;
    TextureMemory memory = squares(7);
    Sampler sampler = anisotropic(most_probes);
    sampler.mip_filter = MipFilter::Linear;
    const TextureUnit unit = memory.compile(sampler);
    Random random(11);
    double sum = 0;
    for (int i = 0; i < Pixels; ++i) {
        const Footprint pixel{below(random, 1 << 20) / 8192.0,
                              below(random, 1 << 20) / 8192.0,
                              ratio * std::cos(Angle),
                              ratio * std::sin(Angle),
                              -std::sin(Angle),
                              std::cos(Angle)};
        const auto planes = make_planes(1, [&](unsigned lane) {
            const double x = lane % 2, y = lane >> 1;
            return Coordinates{
                static_cast<float>((pixel.s + x * pixel.long_s + y * pixel.short_s) / 128),
                static_cast<float>((pixel.t + x * pixel.long_t + y * pixel.short_t) / 128)};
        });
        ColorPlanes out;
        sample(unit, *planes, all_quads(1), out, nullptr);
        const double error = color_of(out, 0)[0] - area_mean(memory, pixel);
        sum += error * error;
    }
    return std::sqrt(sum / Pixels);
}

TEST_CASE("the mean of the probes is close to the texture's mean over the footprint") {
    for (const double ratio : {2.0, 3.0, 4.0, 8.0}) {
        INFO(ratio);
        CHECK(error_against_area(16, ratio) < 6);
        CHECK(error_against_area(1, ratio) > 12);
    }
}

TEST_CASE("a nearest filter takes one probe") {
    const TextureMemory memory = stripes();
    Sampler sampler = anisotropic(16);
    sampler.minify_linear = false;
    TexelFootprints footprints;
    sample_stretched(memory.compile(sampler), 8, &footprints);
    CHECK(footprints.accesses().size() == 4);
}

} // namespace
} // namespace ffgpu::test
