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
    REQUIRE(footprints.accesses.size() == 4 * 7);
    for (unsigned i = 0; i < 7; ++i) {
        CHECK(footprints.accesses[i].lane == 0);
        CHECK(footprints.accesses[i].x0 == 13 + i);
        CHECK(footprints.accesses[i].y0 == 16);
    }
}

TEST_CASE("a nearest filter takes one probe") {
    const TextureMemory memory = stripes();
    Sampler sampler = anisotropic(16);
    sampler.minify_linear = false;
    TexelFootprints footprints;
    sample_stretched(memory.compile(sampler), 8, &footprints);
    CHECK(footprints.accesses.size() == 4);
}

} // namespace
} // namespace ffgpu::test
