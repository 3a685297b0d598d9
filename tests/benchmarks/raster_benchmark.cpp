// Nanoseconds of the rasterizer: a triangle's set-up by what its vertices carry, its coverage by
// its size, a fragment's interpolation by the length of its primitive's run in the batch.

#include "model/raster/interpolator.h"
#include "tests/raster/raster_helpers.h"

#include <benchmark/benchmark.h>

namespace ffgpu::test {
namespace {

constexpr unsigned Triangles = 256;

struct Carried {
    bool flat = false;     // one colour a triangle
    unsigned textures = 0; // two coordinates each
    bool fog = false;
    bool perspective = true;
};

InterpolantLayout layout_of(const Carried& carried) {
    InterpolantLayout layout;
    layout.color = 0;
    layout.count = 4;
    if (carried.fog) layout.fog = static_cast<std::int8_t>(layout.count++);
    for (unsigned unit = 0; unit < carried.textures; ++unit) {
        layout.tex_coord[unit] = static_cast<std::int8_t>(layout.count);
        layout.tex_components[unit] = 2;
        layout.count = static_cast<std::uint8_t>(layout.count + 2);
    }
    return layout;
}

struct Scene {
    SetupContext setup = context();
    std::vector<WindowVertex> vertices;
    std::vector<Primitive> primitives;

    // Triangles some `pixels` wide and high.
    Scene(const Carried& carried, int pixels) {
        Random random(5);
        setup.layout = layout_of(carried);
        vertices.resize(3 * Triangles);
        primitives.resize(Triangles);
        for (unsigned i = 0; i < Triangles; ++i) {
            const int x = random.below((240 - pixels) * 256),
                      y = random.below((240 - pixels) * 256);
            const int size = pixels * 256;
            WindowVertex* const v = vertices.data() + 3 * i;
            v[0] = vertex(x + random.below(100), y + random.below(100));
            v[1] = vertex(x + size - random.below(100), y + random.below(100));
            v[2] = vertex(x + random.below(size), y + size - random.below(100));
            for (unsigned j = 0; j < 3; ++j) {
                v[j].depth = random.unit();
                if (carried.perspective) v[j].inverse_w = 0.3f + random.unit();
                for (float& attribute : v[j].attributes)
                    attribute = random.unit();
                if (carried.flat) std::copy_n(v[0].attributes.begin(), 4, v[j].attributes.begin());
            }
            primitives[i] = {.key = i, .vertices = {&v[0], &v[1], &v[2]}};
        }
    }
};

void set_ups(benchmark::State& state, const Carried& carried) {
    const Scene scene(carried, 6);
    std::vector<RecordBuffer> records(Triangles);
    for ([[maybe_unused]] auto _ : state) {
        for (unsigned i = 0; i < Triangles; ++i)
            set_up(scene.setup, scene.primitives[i], records[i].record());
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) * Triangles);
}

void coverage(benchmark::State& state, int pixels) {
    const Scene scene({}, pixels);
    std::vector<RecordBuffer> records(Triangles);
    for (unsigned i = 0; i < Triangles; ++i)
        records[i].set_up(scene.setup, scene.primitives[i]);
    TileCoverage covered;
    for ([[maybe_unused]] auto _ : state)
        for (unsigned i = 0; i < Triangles; ++i) {
            const SetupRecord& record = records[i].record();
            const int x = record.box.x0 & -64, y = record.box.y0 & -64;
            cover_tile(edge_set(record), {x, y, x + 64, y + 64}, covered);
            benchmark::DoNotOptimize(covered.count);
        }
    state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) * Triangles);
}

// A full batch in runs of so many quads, with depth, a colour, and the textures' coordinates.
void interpolation(benchmark::State& state, const Carried& carried, unsigned run_quads) {
    const Scene scene(carried, 100);
    std::vector<RecordBuffer> records(Triangles);
    std::vector<BatchRun> runs;
    for (unsigned quad = 0; quad < BatchQuads; quad += run_quads) {
        RecordBuffer& buffer = records[runs.size()];
        buffer.set_up(scene.setup, scene.primitives[runs.size()]);
        runs.push_back({&buffer.record(), quad});
    }
    auto batch = std::make_unique<FragmentBatch>();
    auto planes = std::make_unique<PerspectivePlanes>();
    auto coordinates = std::make_unique<TexCoordPlanes>();
    batch->quad_count = BatchQuads;
    for (unsigned q = 0; q < BatchQuads; ++q) {
        batch->x[q] = static_cast<std::uint16_t>(q % 8 * 2 + 64);
        batch->y[q] = static_cast<std::uint16_t>(q / 8 * 2 + 64);
    }
    for ([[maybe_unused]] auto _ : state) {
        interpolate_depth(runs, *batch);
        interpolate_perspective(runs, *batch, *planes);
        interpolate_colors(scene.setup.layout, runs, *planes, *batch);
        for (unsigned unit = 0; unit < carried.textures; ++unit)
            interpolate_tex_coords(scene.setup.layout, unit, runs, *planes, *batch, *coordinates);
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) * BatchFragments);
}

BENCHMARK_CAPTURE(set_ups, flat_fog, Carried{.flat = true, .fog = true});
BENCHMARK_CAPTURE(set_ups, smooth, Carried{});
BENCHMARK_CAPTURE(set_ups, smooth_texture, Carried{.textures = 1});
BENCHMARK_CAPTURE(set_ups, flat_two_textures, Carried{.flat = true, .textures = 2});
BENCHMARK_CAPTURE(set_ups, smooth_two_textures, Carried{.textures = 2});
BENCHMARK_CAPTURE(set_ups, affine_smooth_texture, Carried{.textures = 1, .perspective = false});
BENCHMARK_CAPTURE(coverage, pixels_4, 4);
BENCHMARK_CAPTURE(coverage, pixels_8, 8);
BENCHMARK_CAPTURE(coverage, pixels_16, 16);
BENCHMARK_CAPTURE(coverage, pixels_50, 50);
BENCHMARK_CAPTURE(interpolation, quads_2, Carried{.textures = 1}, 2);
BENCHMARK_CAPTURE(interpolation, quads_7, Carried{.textures = 1}, 7);
BENCHMARK_CAPTURE(interpolation, quads_21, Carried{.textures = 1}, 21);
BENCHMARK_CAPTURE(interpolation, quads_64, Carried{.textures = 1}, 64);
BENCHMARK_CAPTURE(interpolation, flat_fog_quads_7, Carried{.flat = true, .fog = true}, 7);

} // namespace
} // namespace ffgpu::test
