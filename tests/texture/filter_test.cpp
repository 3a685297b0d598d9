// The filter's arithmetic: interpolation against exact numbers, copies without loss, three
// dimensions and two levels.

#include "model/texture/filter.h"
#include "tests/texture/texture_fixture.h"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

namespace ffgpu::test {
namespace {

TextureMemory random_image(Random& random, TextureKind kind, std::uint32_t size) {
    TextureShape shape;
    shape.kind = kind;
    shape.format = Format::Rgba8;
    shape.width = shape.height = size;
    if (kind == TextureKind::ThreeD) shape.depth = size;
    TextureMemory memory(shape);
    memory.fill_random(random);
    return memory;
}

unsigned channel_of(TextureMemory& memory, unsigned layer, unsigned x, unsigned y, unsigned c) {
    return std::to_integer<unsigned>(memory.at(0, layer, x, y)[c]);
}

TEST_CASE("lerp8w is the exact mean rounded to nearest, halves up, for all values and weights") {
    unsigned errors = 0;
    for (unsigned a = 0; a < 256; ++a)
        for (unsigned b = 0; b < 256; b += 3)
            for (unsigned w = 0; w < 256; ++w) {
                const double exact = (a * (256.0 - w) + b * w) / 256;
                errors += lerp8w(a, b, w) != std::floor(exact + 0.5);
            }
    CHECK(errors == 0);
}

// Quads of a screen-aligned rectangle drawn one to one, with an interpolator's rounding errors.
unsigned copy_errors(TextureMemory& memory, const Sampler& sampler, Random& random) {
    const TextureUnit unit = memory.compile(sampler);
    const std::uint32_t size = memory.image.shape.width;
    const float span = unit.normalized ? 1.0f / static_cast<float>(size) : 1.0f;
    unsigned errors = 0;
    for (unsigned row = 0; row + 1 < size; row += size < 128 ? 2 : size / 8 * 2) {
        const auto planes = make_planes(BatchQuads, [&](unsigned lane) {
            const auto noise = [&] {
                return 1 + (static_cast<float>(below(random, 9)) - 4) * 0x1p-23f;
            };
            const auto x = static_cast<float>((lane / 4 * 2 + lane % 2) % size);
            const auto y = static_cast<float>(row + lane / 2 % 2);
            return Coordinates{(x + 0.5f) * span * noise(), (y + 0.5f) * span * noise()};
        });
        ColorPlanes out;
        sample(unit, *planes, all_quads(BatchQuads), out, nullptr);
        for (unsigned lane = 0; lane < BatchFragments; ++lane)
            for (unsigned c = 0; c < 4; ++c)
                errors +=
                    color_of(out, lane)[c] !=
                    channel_of(memory, 0, (lane / 4 * 2 + lane % 2) % size, row + lane / 2 % 2, c);
    }
    return errors;
}

TEST_CASE("a rectangle drawn one to one copies its texels whatever the filter") {
    Random random(5);
    for (const std::uint32_t size : {16u, 100u, 640u, 1024u}) {
        INFO("size " << size);
        TextureMemory memory = random_image(random, TextureKind::TwoD, size);
        CHECK(copy_errors(memory, nearest_sampler(), random) == 0);
        CHECK(copy_errors(memory, linear_sampler(Wrap::ClampToEdge), random) == 0);
        CHECK(copy_errors(memory, linear_sampler(Wrap::Repeat), random) == 0);
    }
    TextureMemory memory = random_image(random, TextureKind::Rectangle, 640);
    CHECK(copy_errors(memory, linear_sampler(Wrap::ClampToEdge), random) == 0);
}

// Exact filter value at texel coordinate (u, v, w) of centres, all inside.
double exact_filter(TextureMemory& memory, std::array<double, 3> at, unsigned c) {
    double sum = 0;
    for (unsigned corner = 0; corner < 8; ++corner) {
        double weight = 1;
        std::array<unsigned, 3> texel{};
        for (unsigned axis = 0; axis < 3; ++axis) {
            const double whole = std::floor(at[axis]);
            const unsigned upper = corner >> axis & 1;
            weight *= upper ? at[axis] - whole : 1 - (at[axis] - whole);
            texel[axis] = static_cast<unsigned>(whole) + upper;
        }
        if (weight > 0) sum += weight * channel_of(memory, texel[2], texel[0], texel[1], c);
    }
    return sum;
}

TEST_CASE("bilinear and 3-D filters are within their roundings of the exact value") {
    Random random(6);
    TextureMemory plane = random_image(random, TextureKind::TwoD, 16);
    TextureMemory volume = random_image(random, TextureKind::ThreeD, 16);
    const TextureUnit plane_unit = plane.compile(linear_sampler());
    const TextureUnit volume_unit = volume.compile(linear_sampler());
    for (unsigned i = 0; i < 2000; ++i) {
        std::array<double, 3> at{};
        std::array<float, 3> coordinate{};
        for (unsigned axis = 0; axis < 3; ++axis) {
            at[axis] = below(random, 15 * 256) / 256.0; // Weights are exact.
            coordinate[axis] = static_cast<float>((at[axis] + 0.5) / 16);
        }
        const Color two = sample_point(plane_unit, {coordinate[0], coordinate[1]});
        const Color three =
            sample_point(volume_unit, {coordinate[0], coordinate[1], coordinate[2]});
        const auto failed = [&](TextureMemory& memory, const Color& color, double roundings) {
            std::array<double, 3> point = at;
            if (&memory == &plane) point[2] = 0;
            for (unsigned c = 0; c < 4; ++c)
                if (std::abs(color[c] - exact_filter(memory, point, c)) > roundings / 2)
                    return true;
            return false;
        };
        REQUIRE_FALSE(failed(plane, two, 2));
        REQUIRE_FALSE(failed(volume, three, 3));
    }
}

TEST_CASE("trilinear mixes two levels by the fraction of the level of detail") {
    TextureShape shape{TextureKind::TwoD, Format::Luminance8, 64, 64, 1, 7, 0};
    TextureMemory memory(shape);
    for (unsigned level = 0; level < 7; ++level)
        std::fill_n(
            memory.at(level, 0, 0, 0), level_layout(shape, level).bytes, std::byte(level * 40));
    Sampler sampler = linear_sampler();
    sampler.mip_filter = MipFilter::Linear;
    for (const int lod : {1, 64, 128, 255, 256, 300, 700, 1535, 1536, 4000}) {
        sampler.min_lod = sampler.max_lod = static_cast<std::int16_t>(lod);
        const int used = std::min(lod, 6 * 256);
        const unsigned fine = static_cast<unsigned>(used >> 8) * 40;
        const unsigned coarse = std::min(fine + 40, 240u);
        CHECK(sample_point(memory.compile(sampler), {0.3f, 0.3f})[0] ==
              lerp8w(fine, coarse, static_cast<unsigned>(used & 0xff)));
    }
}

} // namespace
} // namespace ffgpu::test
