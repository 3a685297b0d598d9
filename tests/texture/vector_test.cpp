// The vector stages against the scalar specification, bit for bit, on random states; the work
// stream against the texels that the specification read.

#include "tests/texture/texture_fixture.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <tuple>

#include <catch2/catch.hpp>
#include <hwy/targets.h>

namespace ffgpu::test {
namespace {

// Powers of two between which the interpolator's numbers lie: of coordinates, of directions.
struct Magnitudes {
    int least, most;
};
constexpr Magnitudes OfCoordinates{-91, 108}, OfDirections{-32, 60};

float random_float(Random& random, Magnitudes magnitudes) {
    const auto unit = [&] { return static_cast<float>(random() >> 8) * 0x1p-24f; };
    switch (below(random, 16)) {
    case 0:
    case 1: {
        const auto span = static_cast<std::uint32_t>(magnitudes.most - magnitudes.least);
        const std::uint32_t exponent =
            static_cast<std::uint32_t>(127 + magnitudes.least) + below(random, span);
        return std::bit_cast<float>((exponent << 23) |
                                    (static_cast<std::uint32_t>(random()) & 0x807fffff));
    }
    case 2:
        return static_cast<float>(static_cast<int>(below(random, 9)) - 4) * 0.5f;
    case 3:
        return (unit() - 0.5f) * 0x1p30f;
    default:
        return (unit() - 0.25f) * 4;
    }
}

TextureShape random_shape(Random& random) {
    TextureShape shape;
    shape.kind = static_cast<TextureKind>(1 + below(random, 5));
    shape.format =
        static_cast<Format>(1 + below(random, static_cast<unsigned>(Format::Depth24Stencil8)));
    const std::uint32_t most = shape.kind == TextureKind::ThreeD ? 16 : 70;
    const auto size = [&] {
        const std::uint32_t any = 1 + below(random, most);
        return random() % 2 ? std::bit_floor(any) : any;
    };
    shape.width = size();
    shape.height = shape.kind == TextureKind::OneD ? 1 : size();
    shape.depth = shape.kind == TextureKind::ThreeD ? size() : 1;
    shape.border = shape.kind != TextureKind::Rectangle && below(random, 4) == 0;
    shape.levels = 1 + below(random, 7);
    return shape;
}

Sampler random_sampler(Random& random) {
    Sampler sampler;
    for (Wrap& wrap : sampler.wrap)
        wrap = static_cast<Wrap>(below(random, 8));
    sampler.magnify_linear = random() % 2;
    sampler.minify_linear = random() % 4 != 0;
    sampler.mip_filter = static_cast<MipFilter>(below(random, 3));
    sampler.max_level = static_cast<std::uint8_t>(below(random, 13));
    sampler.bias = static_cast<std::int16_t>(static_cast<int>(below(random, 1024)) - 512);
    if (random() % 4 == 0) sampler.min_lod = static_cast<std::int16_t>(below(random, 1024));
    if (random() % 4 == 0) sampler.max_lod = static_cast<std::int16_t>(below(random, 1024));
    if (random() % 3 == 0) sampler.max_anisotropy = static_cast<std::uint8_t>(below(random, 18));
    sampler.compare_enable = random() % 2;
    sampler.compare = static_cast<Compare>(below(random, 8));
    sampler.depth_mode = static_cast<DepthMode>(below(random, 3));
    sampler.border_color = static_cast<std::uint32_t>(random());
    sampler.border_depth = static_cast<std::uint32_t>(random()) & 0xffffff;
    return sampler;
}

// Half of the batches are smooth, as a triangle's are, with any steepness; the others are noise.
std::unique_ptr<TexCoordPlanes>
random_planes(Random& random, unsigned quads, Magnitudes magnitudes) {
    if (random() % 2)
        return make_planes(quads, [&](unsigned) {
            const auto one = [&] { return random_float(random, magnitudes); };
            return Coordinates{one(), one(), one()};
        });
    const auto step = [&] {
        const float power = std::bit_cast<float>((116 + below(random, 14)) << 23);
        return power * (static_cast<float>(below(random, 4096)) / 2048.0f - 1);
    };
    std::array<std::array<float, 3>, 3> plane;
    for (auto& coefficients : plane)
        for (float& coefficient : coefficients)
            coefficient = step();
    return make_planes(quads, [&](unsigned lane) {
        const auto x = static_cast<float>(lane / 4 % 8 * 2 + lane % 2);
        const auto y = static_cast<float>(lane / 32 * 2 + lane / 2 % 2);
        const auto at = [&](unsigned i) { return plane[i][0] + x * plane[i][1] + y * plane[i][2]; };
        return Coordinates{at(0), at(1), at(2)};
    });
}

FragmentMask random_mask(Random& random, unsigned quads) {
    FragmentMask mask;
    for (unsigned lane = 0; lane < 4 * quads; ++lane)
        if (random() % 4) mask.set(lane);
    return mask;
}

using Texel = std::tuple<unsigned, unsigned, unsigned, unsigned>; // level, layer, x, y

struct Reads : TexelObserver {
    std::vector<Texel> texels;
    void read(unsigned level, unsigned layer, unsigned x, unsigned y) override {
        texels.emplace_back(level, layer, x, y);
    }
};

// The texels of an access in the order of the filter: along x, then y, then the layers.
void expand(const TexelAccess& access, std::vector<Texel>& texels) {
    for (unsigned z = 0; z < 1 + (access.linear >> 2 & 1u); ++z)
        for (unsigned y = 0; y < 1 + (access.linear >> 1 & 1u); ++y)
            for (unsigned x = 0; x < 1 + (access.linear & 1u); ++x)
                texels.emplace_back(access.level,
                                    z ? access.layer1 : access.layer0,
                                    x ? access.x1 : access.x0,
                                    y ? access.y1 : access.y0);
}

void compare_batches(const TextureUnit& unit, Random& random) {
    const unsigned quads = 1 + below(random, BatchQuads);
    const auto planes =
        random_planes(random, quads, unit.kind == TextureKind::Cube ? OfDirections : OfCoordinates);
    const SampleQuads lanes{quads, random_mask(random, quads), random_mask(random, quads)};
    ColorPlanes expected, actual;
    TexelFootprints expected_reads, actual_reads;
    Reads reads;
    sample_scalar(unit, *planes, lanes, expected, &expected_reads, &reads);
    sample(unit, *planes, lanes, actual, &actual_reads);

    unsigned differences = 0;
    for (unsigned lane = 0; lane < 4 * quads; ++lane)
        differences += color_of(expected, lane) != color_of(actual, lane);
    CHECK(differences == 0);

    CHECK((expected_reads.accesses() == actual_reads.accesses()));
    std::vector<Texel> recorded;
    for (const TexelAccess& access : actual_reads.accesses())
        expand(access, recorded);
    const bool same_texels = recorded == reads.texels;
    CHECK(same_texels);
}

void compare_states(unsigned seed, unsigned states) {
    Random random(seed);
    for (unsigned state = 0; state < states; ++state) {
        TextureMemory memory(random_shape(random), 64 * below(random, 4));
        memory.image.srgb = random() % 4 == 0;
        memory.fill_random(random);
        const Sampler sampler = random_sampler(random);
        const TextureUnit unit = memory.compile(sampler);
        INFO("state " << state << " kind " << static_cast<int>(unit.kind) << " format "
                      << static_cast<int>(unit.format) << " wrap "
                      << static_cast<int>(sampler.wrap[0]) << " size " << unit.size[0] << " x "
                      << unit.size[1] << " border " << unit.border << " srgb " << unit.srgb);
        REQUIRE(unit.valid);
        for (unsigned batch = 0; batch < 3; ++batch)
            compare_batches(unit, random);
    }
}

TEST_CASE("the vector stages equal the reference bit for bit, and the work stream its reads") {
    compare_states(20030729, 4000); // With the processor's best instruction set.
}

TEST_CASE("every instruction set gives the reference's bits") {
    const std::int64_t supported = hwy::SupportedTargets();
    for (const std::int64_t target : {std::int64_t{HWY_SSE4}, std::int64_t{HWY_AVX2}}) {
        if ((supported & target) == 0) continue;
        INFO("target " << hwy::TargetName(target));
        hwy::SetSupportedTargetsForTest(target);
        compare_states(static_cast<unsigned>(target), 2000);
    }
    hwy::SetSupportedTargetsForTest(0);
}

TEST_CASE("a processor without vectors gives the reference's bits") {
    hwy::SetSupportedTargetsForTest(HWY_STATIC_TARGET);
    compare_states(7, 100);
    hwy::SetSupportedTargetsForTest(0);
}

} // namespace
} // namespace ffgpu::test
