// Depth textures: comparisons, percentage-closer filtering, depth modes, the border's depth.

#include "model/texture/depth_compare.h"
#include "tests/texture/texture_fixture.h"

#include <cmath>

#include <catch2/catch.hpp>

namespace ffgpu::test {
namespace {

TextureMemory depth_texture(std::initializer_list<std::uint32_t> depths24, std::uint32_t width) {
    const auto count = static_cast<std::uint32_t>(depths24.size());
    TextureMemory memory(
        {TextureKind::TwoD, Format::Depth24Stencil8, width, count / width, 1, 1, 0});
    std::uint32_t i = 0;
    for (const std::uint32_t depth : depths24) {
        memory.put_rgba8(0, 0, i % width, i / width, depth << 8 | 0x5a); // The stencil is noise.
        ++i;
    }
    return memory;
}

Sampler compare_sampler(Compare compare, bool linear) {
    Sampler sampler = linear ? linear_sampler(Wrap::ClampToEdge) : nearest_sampler();
    sampler.compare_enable = true;
    sampler.compare = compare;
    return sampler;
}

TEST_CASE("each comparison tells r below, at and above the texel's depth") {
    const TextureMemory memory = depth_texture({0x800000}, 1);
    // Passes for r < D, r = D, r > D.
    const std::array<std::array<unsigned, 3>, 8> passes{
        {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}}};
    for (unsigned compare = 0; compare < 8; ++compare) {
        const TextureUnit unit =
            memory.compile(compare_sampler(static_cast<Compare>(compare), false));
        for (unsigned i = 0; i < 3; ++i) {
            const auto reference = static_cast<float>((0x7fffff + i) / 16777215.0);
            CHECK(sample_point(unit, {0.5f, 0.5f, reference})[0] == passes[compare][i] * 255);
        }
    }
}

TEST_CASE("a linear filter weighs the outcomes of four comparisons") {
    const TextureMemory memory = depth_texture({0, 0xffffff, 0xffffff, 0xffffff}, 2);
    const TextureUnit unit = memory.compile(compare_sampler(Compare::Lequal, true));
    CHECK(sample_point(unit, {0.25f, 0.25f, 0.5f})[0] == 0);
    CHECK(sample_point(unit, {0.75f, 0.25f, 0.5f})[0] == 255);
    CHECK(sample_point(unit, {0.5f, 0.25f, 0.5f})[0] == 128);
    CHECK(sample_point(unit, {0.5f, 0.5f, 0.5f})[0] == 192);
    CHECK(sample_point(unit, {0.5f, 0.5f, 0.0f})[0] == 255);
}

TEST_CASE("r is clamped to the depth range") {
    const TextureMemory memory = depth_texture({0xffffff}, 1);
    const TextureUnit unit = memory.compile(compare_sampler(Compare::Equal, false));
    CHECK(sample_point(unit, {0, 0, 1})[0] == 255);
    CHECK(sample_point(unit, {0, 0, 7})[0] == 255);
    CHECK(sample_point(unit, {0, 0, 0x1p100f})[0] == 255);
    CHECK(sample_point(unit, {0, 0, -0x1p100f})[0] == 0);
    CHECK(reference_depth(-1) == 0);
    CHECK(reference_depth(0.5f) == 0x800000); // 8388607.5, ties to even
}

TEST_CASE("without comparison the leading 8 bits appear, as the depth mode says") {
    const TextureMemory memory = depth_texture({0x80ffff}, 1);
    Sampler sampler = nearest_sampler();
    CHECK(sample_point(memory.compile(sampler), {}) == Color{0x80, 0x80, 0x80, 255});
    sampler.depth_mode = DepthMode::Intensity;
    CHECK(sample_point(memory.compile(sampler), {}) == Color{0x80, 0x80, 0x80, 0x80});
    sampler.depth_mode = DepthMode::Alpha;
    CHECK(sample_point(memory.compile(sampler), {}) == Color{0, 0, 0, 0x80});
}

TEST_CASE("16-bit depths compare at 24 bits, the far plane at both") {
    TextureMemory memory({TextureKind::TwoD, Format::Depth16, 2, 1, 1, 1, 0});
    memory.at(0, 0, 0, 0)[0] = memory.at(0, 0, 0, 0)[1] = std::byte{0xff};
    memory.at(0, 0, 1, 0)[0] = std::byte{0x34};
    memory.at(0, 0, 1, 0)[1] = std::byte{0x12};
    const TextureUnit unit = memory.compile(compare_sampler(Compare::Equal, false));
    CHECK(sample_point(unit, {0.25f, 0, 1})[0] == 255);
    CHECK(sample_point(unit, {0.75f, 0, static_cast<float>(0x123412 / 16777215.0)})[0] == 255);
    CHECK(sample_point(unit, {0.75f, 0, static_cast<float>(0x123413 / 16777215.0)})[0] == 0);
}

TEST_CASE("beyond the edge the border's depth is compared") {
    const TextureMemory memory = depth_texture({0}, 1);
    Sampler sampler = compare_sampler(Compare::Lequal, false);
    sampler.wrap = {Wrap::ClampToBorder, Wrap::ClampToBorder, Wrap::Repeat};
    sampler.border_depth = 0xffffff;
    const TextureUnit unit = memory.compile(sampler);
    CHECK(sample_point(unit, {0.5f, 0.5f, 0.5f})[0] == 0);
    CHECK(sample_point(unit, {2.5f, 0.5f, 0.5f})[0] == 255);
}

} // namespace
} // namespace ffgpu::test
