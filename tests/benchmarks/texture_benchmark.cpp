// Nanoseconds a fragment of the texture unit, by filter, format and wrap; with and without a work
// stream. One batch of 256 fragments over a 256x256 texture with all levels.

#include "tests/texture/texture_fixture.h"

#include <benchmark/benchmark.h>
#include <hwy/targets.h>

namespace ffgpu::test {
namespace {

struct Case {
    Format format = Format::Rgba8;
    bool srgb = false;
    TextureKind kind = TextureKind::TwoD;
    Wrap wrap = Wrap::Repeat;
    bool linear = true;
    MipFilter mip = MipFilter::None;
    float texels_per_pixel = 1.3f;
    bool mixed_levels = false;
    unsigned anisotropy = 1;
    bool footprints = false;
    std::int64_t instructions = 0; // Highway's target, 0: the best
};

// A tile of 16x16 pixels, turned a little; with mixed levels the scale grows from left to right.
std::unique_ptr<TexCoordPlanes> tile(const Case& c, float size) {
    return make_planes(BatchQuads, [&](unsigned lane) {
        const auto x = static_cast<float>(lane / 4 % 8 * 2 + lane % 2);
        const auto y = static_cast<float>(lane / 32 * 2 + lane / 2 % 2);
        const float grow = c.mixed_levels ? 1 + x * 0.2f : 1;
        const float scale = c.texels_per_pixel * grow / size;
        const float stretch = c.anisotropy > 1 ? 4 : 1;
        return Coordinates{0.1f + (x * 0.9f - y * 0.3f) * scale * stretch,
                           0.2f + (y * 0.9f + x * 0.3f) * scale,
                           0.3f};
    });
}

void run(benchmark::State& state, const Case& c) {
    TextureShape shape;
    shape.kind = c.kind;
    shape.format = c.format;
    const bool three_d = c.kind == TextureKind::ThreeD;
    shape.width = shape.height = three_d ? 64 : 256;
    shape.depth = three_d ? 64 : 1;
    shape.levels = three_d ? 7 : 9;
    TextureMemory memory(shape);
    memory.image.srgb = c.srgb;
    Random random(1);
    memory.fill_random(random);
    Sampler sampler = c.linear ? linear_sampler(c.wrap) : nearest_sampler(c.wrap);
    sampler.mip_filter = c.mip;
    sampler.max_anisotropy = static_cast<std::uint8_t>(c.anisotropy);
    const TextureUnit unit = memory.compile(sampler);
    const auto planes = tile(c, static_cast<float>(shape.width));
    const SampleQuads quads = all_quads(BatchQuads);
    ColorPlanes out;
    TexelFootprints footprints;
    hwy::SetSupportedTargetsForTest(c.instructions);
    for ([[maybe_unused]] auto _ : state) {
        footprints = {};
        sample(unit, *planes, quads, out, c.footprints ? &footprints : nullptr);
        benchmark::DoNotOptimize(out);
    }
    hwy::SetSupportedTargetsForTest(0);
    state.counters["fragment"] = benchmark::Counter(BatchFragments,
                                                    benchmark::Counter::kIsIterationInvariantRate |
                                                        benchmark::Counter::kInvert);
}

constexpr MipFilter Trilinear = MipFilter::Linear;

BENCHMARK_CAPTURE(run, nearest_rgba8, Case{.linear = false});
BENCHMARK_CAPTURE(run, bilinear_rgba8, Case{});
BENCHMARK_CAPTURE(run, bilinear_rgba8_footprints, Case{.footprints = true});
BENCHMARK_CAPTURE(run, bilinear_rgba8_clamp_border, Case{.wrap = Wrap::Clamp});
BENCHMARK_CAPTURE(run, bilinear_rgba8_mirror, Case{.wrap = Wrap::MirroredRepeat});
BENCHMARK_CAPTURE(run, bilinear_luminance8, Case{.format = Format::Luminance8});
BENCHMARK_CAPTURE(run, bilinear_rgb565, Case{.format = Format::Rgb565});
BENCHMARK_CAPTURE(run, bilinear_dxt1, Case{.format = Format::Dxt1Rgb});
BENCHMARK_CAPTURE(run, bilinear_dxt5, Case{.format = Format::Dxt5});
BENCHMARK_CAPTURE(run, bilinear_fxt1, Case{.format = Format::Fxt1Rgb});
BENCHMARK_CAPTURE(run, bilinear_srgb8_alpha8, Case{.srgb = true});
BENCHMARK_CAPTURE(run, bilinear_depth24, Case{.format = Format::Depth24Stencil8});
BENCHMARK_CAPTURE(run, bilinear_cube, Case{.kind = TextureKind::Cube});
BENCHMARK_CAPTURE(run, linear_3d, Case{.kind = TextureKind::ThreeD});
BENCHMARK_CAPTURE(run, trilinear_rgba8, Case{.mip = Trilinear});
BENCHMARK_CAPTURE(run, trilinear_rgba8_footprints, Case{.mip = Trilinear, .footprints = true});
BENCHMARK_CAPTURE(run, trilinear_rgba8_mixed, Case{.mip = Trilinear, .mixed_levels = true});
BENCHMARK_CAPTURE(run, trilinear_dxt1, Case{.format = Format::Dxt1Rgb, .mip = Trilinear});
BENCHMARK_CAPTURE(run, anisotropic_8, Case{.mip = Trilinear, .anisotropy = 8});

BENCHMARK_CAPTURE(run, nearest_rgba8_avx2, Case{.linear = false, .instructions = HWY_AVX2});
BENCHMARK_CAPTURE(run, bilinear_rgba8_avx2, Case{.instructions = HWY_AVX2});
BENCHMARK_CAPTURE(run,
                  bilinear_rgba8_footprints_avx2,
                  Case{.footprints = true, .instructions = HWY_AVX2});
BENCHMARK_CAPTURE(run, trilinear_rgba8_avx2, Case{.mip = Trilinear, .instructions = HWY_AVX2});
BENCHMARK_CAPTURE(run,
                  trilinear_rgba8_mixed_avx2,
                  Case{.mip = Trilinear, .mixed_levels = true, .instructions = HWY_AVX2});

} // namespace
} // namespace ffgpu::test
