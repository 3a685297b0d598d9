// Ties the frozen arithmetic of planes and texels to its version: a hash over what its
// specifications give for seeded inputs stands in docs/arithmetic.md beside the version. A change
// of results is a new version. The fragment units: tests/fragment/arithmetic_version_test.cpp.

#include "model/raster/attribute_setup.h"
#include "model/raster/interpolator.h"
#include "model/texture/texture_unit.h"
#include "tests/raster/raster_helpers.h"
#include "tests/support/seal.h"

#include <memory>
#include <string>

#include <catch2/catch.hpp>

using namespace ffgpu;
using namespace ffgpu::test;

namespace {

InterpolantLayout sealed_layout() {
    InterpolantLayout layout;
    layout.color = 0;
    layout.fog = 4;
    layout.tex_coord[0] = 5;
    layout.tex_components[0] = 4;
    layout.count = 9;
    return layout;
}

// A batch of 64 quads, interpolated and sampled.
void seal_batch(Random& random, const SetupRecord& record, const TextureUnit& unit, Seal& seal) {
    auto batch = std::make_unique<FragmentBatch>();
    auto planes = std::make_unique<PerspectivePlanes>();
    auto coords = std::make_unique<TexCoordPlanes>();
    batch->quad_count = BatchQuads;
    for (unsigned q = 0; q < BatchQuads; ++q) {
        batch->x[q] = static_cast<std::uint16_t>(q % 8 * 2);
        batch->y[q] = static_cast<std::uint16_t>(q / 8 * 2);
    }
    const BatchRun run{&record, 0};
    interpolate_depth_scalar({&run, 1}, *batch);
    interpolate_perspective_scalar({&run, 1}, *batch, *planes);
    interpolate_colors_scalar(sealed_layout(), {&run, 1}, *planes, *batch);
    interpolate_tex_coords_scalar(sealed_layout(), 0, {&run, 1}, *planes, *batch, *coords);
    FragmentMask covered;
    for (unsigned lane = 0; lane < BatchFragments; ++lane)
        if (random.below(4)) covered.set(lane);
    auto out = std::make_unique<ColorPlanes>();
    sample_scalar(unit, *coords, {BatchQuads, covered, covered}, *out, nullptr);
    for (unsigned lane = 0; lane < BatchFragments; ++lane) {
        seal.add(std::uint64_t{batch->depth[lane]});
        seal.add(planes->w[lane]);
        seal.add(std::uint64_t{batch->primary.r[lane]});
        seal.add(batch->fog_coordinate[lane]);
        seal.add(coords->s[lane]);
        seal.add(coords->r[lane]);
        for (const auto* plane : {&out->r, &out->g, &out->b, &out->a})
            seal.add(std::uint64_t{(*plane)[lane]});
    }
}

std::string seal_of_this_build() {
    Random random(2);
    Seal seal;
    SetupContext setup = context();
    setup.layout = sealed_layout();
    RecordBuffer buffer;
    const TextureShape shape{TextureKind::TwoD, Format::Rgba8, 64, 64, 1, 7, 0};
    std::vector<std::byte> texels(texture_bytes(shape) + 64);
    for (std::byte& byte : texels)
        byte = static_cast<std::byte>(random.below(256));
    for (unsigned n = 0; n < 300; ++n) {
        Sampler sampler;
        sampler.wrap.fill(static_cast<Wrap>(n % 8));
        sampler.magnify_linear = sampler.minify_linear = true;
        sampler.mip_filter = static_cast<MipFilter>(n % 3);
        sampler.max_anisotropy = static_cast<std::uint8_t>(n % 5 ? 1 : 8);
        // The quads lie within the triangle: no lane is further out than it may be.
        WindowVertex v[3] = {vertex(-9000 - random.below(9000), -9000 - random.below(9000)),
                             vertex(16000 + random.below(9000), -5000 - random.below(9000)),
                             vertex(-5000 - random.below(5000), 16000 + random.below(9000))};
        for (WindowVertex& each : v) {
            each.depth = random.unit();
            each.inverse_w = n % 3 ? 0.05f + random.unit() : 0.5f;
            for (float& attribute : each.attributes)
                attribute = random.unit() * 4 - 1;
            for (unsigned i = 0; i < 4; ++i)
                each.attributes[i] = random.unit();
            each.attributes[8] = n % 2 ? 1.0f : 0.5f + random.unit();
        }
        if (!buffer.triangle(setup, v[0], v[1], v[2])) continue;
        seal_batch(
            random, buffer.record(), compile_texture_unit({shape, 0}, sampler, texels), seal);
    }
    return seal.text();
}

} // namespace

TEST_CASE("the frozen arithmetic gives the results that its version is sealed with") {
    const std::string seal = "Arithmetic 2, sealed " + seal_of_this_build();
    INFO("this build: " << seal);
    CHECK(arithmetic_page().find(seal) != std::string::npos);
}
