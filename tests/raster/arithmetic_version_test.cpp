// Ties the frozen arithmetic of planes and texels to its version: a hash over what its
// specifications give for seeded inputs stands in docs/arithmetic.md beside the version. A change
// of results is a new version. The fragment units: tests/fragment/arithmetic_version_test.cpp.

#include "model/raster/attribute_setup.h"
#include "model/raster/interpolator.h"
#include "model/raster/sample_coverage.h"
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
        const auto off = [&](int reach) {
            return reach < 0 ? -random.below(-reach) : random.below(reach);
        };
        // One after the other: in a call compilers may draw numbers in any order.
        const auto corner = [&](int x, int reach_x, int y, int reach_y) {
            y += off(reach_y);
            x += off(reach_x);
            return vertex(x, y);
        };
        WindowVertex v[3] = {corner(-9000, -9000, -9000, -9000),
                             corner(16000, 9000, -5000, -9000),
                             corner(-5000, -5000, 16000, 9000)};
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

std::string seal_of_coverage() {
    Random random(3);
    Seal seal;
    RecordBuffer buffer;
    auto centres = std::make_unique<TileCoverage>();
    auto samples = std::make_unique<TileSampleCoverage>();
    SetupContext sampled = context();
    sampled.multisample = true;
    const auto near = [&] {
        const int x = random.between(-2000, 18000), y = random.between(-2000, 18000);
        return random.below(2) ? vertex(x, y) : vertex(x & ~127, y & ~127); // ties
    };
    for (unsigned n = 0; n < 400; ++n) {
        const WindowVertex a = near(), b = near(), c = near();
        const Rectangle tile{0, 0, 64, 64};
        if (buffer.triangle(context(), a, b, c)) {
            cover_tile_scalar(edge_set(buffer.record()), tile, *centres);
            for_each_pixel(*centres, [&](int x, int y) {
                seal.add(static_cast<std::uint64_t>(x) << 32 | static_cast<std::uint32_t>(y));
            });
        }
        if (!buffer.triangle(sampled, a, b, c)) continue;
        cover_tile_samples_scalar(buffer.record(), tile, *samples);
        for (unsigned i = 0; i < samples->count; ++i)
            for (const BlockMask mask : samples->blocks[i].masks)
                seal.add(mask);
    }
    return seal.text();
}

// One batch of coordinates that vary from 1/8 to 8 texels a pixel.
void seal_texture(Random& random, const TextureShape& shape, const Sampler& sampler, Seal& seal) {
    std::vector<std::byte> texels(texture_bytes(shape) + 64);
    for (std::byte& byte : texels)
        byte = static_cast<std::byte>(random.below(256));
    const float size = shape.kind == TextureKind::Rectangle ? 16.0f : 1.0f;
    const float step = size / 128 * static_cast<float>(1 << random.below(7));
    auto planes = std::make_unique<TexCoordPlanes>();
    for (unsigned q = 0; q < BatchQuads; ++q) {
        const float s = (random.unit() * 3 - 1) * size, t = (random.unit() * 3 - 1) * size;
        const float r = random.unit() * 2 - 0.5f;
        for (unsigned i = 0; i < 4; ++i) {
            planes->s[4 * q + i] = s + step * static_cast<float>(i & 1);
            planes->t[4 * q + i] = t + step * static_cast<float>(i >> 1);
            planes->r[4 * q + i] = r;
        }
    }
    FragmentMask all;
    for (unsigned lane = 0; lane < BatchFragments; ++lane)
        all.set(lane);
    auto out = std::make_unique<ColorPlanes>();
    const TextureUnit unit = compile_texture_unit({shape, 0}, sampler, texels);
    sample_scalar(unit, *planes, {BatchQuads, all, all}, *out, nullptr);
    for (const auto* plane : {&out->r, &out->g, &out->b, &out->a})
        for (const std::uint16_t value : *plane)
            seal.add(std::uint64_t{value});
}

Sampler sealed_sampler(Random& random) {
    Sampler sampler;
    sampler.wrap.fill(static_cast<Wrap>(random.below(8)));
    sampler.magnify_linear = random.below(2) != 0;
    sampler.minify_linear = random.below(2) != 0;
    sampler.mip_filter = static_cast<MipFilter>(random.below(3));
    sampler.bias = static_cast<std::int16_t>(random.below(1024) - 512);
    sampler.min_lod = static_cast<std::int16_t>(random.below(512));
    sampler.border_color = 0x80c040ff;
    return sampler;
}

std::string seal_of_formats() {
    Random random(4);
    Seal seal;
    for (unsigned format = 1; format <= static_cast<unsigned>(Format::Fxt1Rgba); ++format)
        for (unsigned n = 0; n < 20; ++n)
            seal_texture(random,
                         {TextureKind::TwoD, static_cast<Format>(format), 16, 16, 1, 5, 0},
                         sealed_sampler(random),
                         seal);
    return seal.text();
}

std::string seal_of_kinds() {
    Random random(5);
    Seal seal;
    for (unsigned n = 0; n < 40; ++n) {
        const auto add = [&](TextureKind kind, std::uint32_t height, std::uint32_t depth) {
            const std::uint8_t levels = kind == TextureKind::Rectangle ? 1 : 5;
            Sampler sampler = sealed_sampler(random);
            if (kind == TextureKind::Rectangle) {
                sampler.wrap.fill(Wrap::ClampToEdge);
                sampler.mip_filter = MipFilter::None;
            }
            seal_texture(
                random, {kind, Format::Rgba8, 16, height, depth, levels, 0}, sampler, seal);
        };
        add(TextureKind::OneD, 1, 1);
        add(TextureKind::ThreeD, 16, 16);
        add(TextureKind::Cube, 16, 1);
        add(TextureKind::Rectangle, 16, 1);
    }
    return seal.text();
}

std::string seal_of_depth_textures() {
    Random random(6);
    Seal seal;
    for (const Format format : {Format::Depth16, Format::Depth24Stencil8})
        for (unsigned n = 0; n < 64; ++n) {
            Sampler sampler = sealed_sampler(random);
            sampler.compare_enable = n % 4 != 0;
            sampler.compare = static_cast<Compare>(n % 8);
            sampler.depth_mode = static_cast<DepthMode>(n % 3);
            sampler.border_depth = 0x800000;
            seal_texture(random, {TextureKind::TwoD, format, 16, 16, 1, 5, 0}, sampler, seal);
        }
    return seal.text();
}

} // namespace

TEST_CASE("the frozen arithmetic gives the results that its version is sealed with") {
    const std::string seal = "Arithmetic 3, sealed " + seal_of_this_build();
    INFO("this build: " << seal);
    CHECK(arithmetic_page().find(seal) != std::string::npos);
}

TEST_CASE("coverage and texels of every kind give the results that their version is sealed with") {
    const std::string page = arithmetic_page();
    const struct {
        const char* part;
        std::string seal;
    } parts[] = {{"coverage by centres and samples", seal_of_coverage()},
                 {"texels by format", seal_of_formats()},
                 {"kinds of texture and cube faces", seal_of_kinds()},
                 {"depth textures and their comparison", seal_of_depth_textures()}};
    for (const auto& [part, seal] : parts) {
        const std::string row = std::string("| ") + part + " | `" + seal + "` |";
        INFO("this build: " << row);
        CHECK(page.find(row) != std::string::npos);
    }
}
