#include "model/raster/interpolator.h"
#include "tests/raster/raster_helpers.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include <catch2/catch.hpp>
#include <hwy/targets.h>

using namespace ffgpu;
using namespace ffgpu::test;

namespace {

// Colour, secondary, fog, two coordinates of unit 0, four of unit 3.
InterpolantLayout full_layout() {
    InterpolantLayout layout;
    layout.color = 0;
    layout.secondary = 4;
    layout.fog = 7;
    layout.tex_coord[0] = 8;
    layout.tex_components[0] = 2;
    layout.tex_coord[3] = 10;
    layout.tex_components[3] = 4;
    layout.count = 14;
    return layout;
}

WindowVertex random_vertex(Random& random, bool perspective) {
    WindowVertex v = vertex(random.between(-2000, 40000),
                            random.between(-2000, 40000),
                            random.unit(),
                            perspective ? 0.01f + random.unit() * 3 : 0.25f);
    for (float& attribute : v.attributes)
        attribute = random.unit() * 3 - 1;
    return v;
}

// Batches of many small and large primitives, as a tile makes them.
template <class Visit>
void for_each_batch(unsigned seed, Visit&& visit) {
    Random random(seed);
    SetupContext setup = context();
    setup.layout = full_layout();
    auto batch = std::make_unique<FragmentBatch>();
    auto collector = std::make_unique<QuadCollector>(*batch);
    std::vector<RecordBuffer> buffers(200);
    TileCoverage coverage;
    const Rectangle tile{64, 0, 128, 64};
    collector->begin_tile(tile);
    const auto flush = [&] {
        if (!collector->empty()) visit(setup.layout, collector->runs(), *batch);
        collector->clear();
    };
    for (std::uint32_t i = 0; i < buffers.size(); ++i) {
        WindowVertex a = random_vertex(random, i % 3 != 0);
        WindowVertex b = random_vertex(random, i % 3 != 0);
        WindowVertex c = random_vertex(random, i % 3 != 0);
        if (i % 4 != 0) { // Small ones.
            b.x = a.x + random.between(-900, 900), b.y = a.y + random.between(-900, 900);
            c.x = a.x + random.between(-900, 900), c.y = a.y + random.between(-900, 900);
        }
        if (i % 7 == 0) b.attributes = c.attributes = a.attributes;
        if (i % 6 == 0) b.depth = c.depth = a.depth;
        if (i % 31 == 0) a.attributes[2] = 0;
        if (i % 37 == 0) a.attributes[9] = -0x1p59f;
        if (i % 41 == 0) a.attributes[13] = b.attributes[13] = 0;
        if (i % 5 == 0) a.attributes[13] = b.attributes[13] = c.attributes[13] = 1;
        setup.primitive.offset_fill = i % 5 == 0;
        setup.primitive.offset_factor = 2;
        setup.primitive.offset_units = -3;
        if (!buffers[i].triangle(setup, a, b, c, i)) continue;
        cover_tile(edge_set(buffers[i].record()), tile, coverage);
        for (unsigned block = 0; block < coverage.count; ++block)
            collector->add(buffers[i].record(), coverage.blocks[block], nullptr, flush);
    }
    flush();
}

template <class Array>
bool same_lanes(const Array& a, const Array& b, unsigned lanes) {
    return std::memcmp(a.data(), b.data(), lanes * sizeof a[0]) == 0;
}

bool same_colors(const ColorPlanes& a, const ColorPlanes& b, unsigned lanes) {
    return same_lanes(a.r, b.r, lanes) && same_lanes(a.g, b.g, lanes) &&
           same_lanes(a.b, b.b, lanes) && same_lanes(a.a, b.a, lanes);
}

// Colours as words against the specification's planes.
void check_color_words(const InterpolantLayout& layout,
                       std::span<const BatchRun> runs,
                       const PerspectivePlanes& perspective,
                       const FragmentBatch& scalar) {
    std::array<std::uint32_t, BatchFragments> words;
    interpolate_color_words(layout, runs, perspective, scalar.lanes(), words);
    const ColorPlanes& color = scalar.primary;
    for (unsigned lane = 0; lane < scalar.lanes(); ++lane) {
        const auto alpha = static_cast<std::uint32_t>(color.a[lane]);
        REQUIRE(words[lane] == (color.r[lane] | static_cast<unsigned>(color.g[lane]) << 8 |
                                static_cast<unsigned>(color.b[lane]) << 16 | alpha << 24));
    }
}

// What is said to be full is, and of runs of white all is said to be.
void check_full_channels(std::span<const BatchRun> runs, const FragmentBatch& batch) {
    const ColorPlanes& color = batch.primary;
    const std::array<const std::uint16_t*, 4> planes{
        color.r.data(), color.g.data(), color.b.data(), color.a.data()};
    for (unsigned i = 0; i < 4; ++i) {
        const bool constant = std::all_of(runs.begin(), runs.end(), [&](const BatchRun& run) {
            return run.record->constant_color && run.record->color[i] == 255;
        });
        REQUIRE((batch.full_channels >> i & 1) == unsigned{constant});
        if (constant)
            REQUIRE(std::all_of(planes[i], planes[i] + batch.lanes(), [](std::uint16_t value) {
                return value == 255;
            }));
    }
}

void compare_forms() {
    unsigned batches = 0;
    auto scalar_batch = std::make_unique<FragmentBatch>();
    auto scalar = std::make_unique<PerspectivePlanes>();
    auto vector = std::make_unique<PerspectivePlanes>();
    auto scalar_coords = std::make_unique<TexCoordPlanes>();
    auto vector_coords = std::make_unique<TexCoordPlanes>();
    auto scalar_depths = std::make_unique<SampleDepths>();
    auto vector_depths = std::make_unique<SampleDepths>();
    for_each_batch(
        11,
        [&](const InterpolantLayout& layout, std::span<const BatchRun> runs, FragmentBatch& batch) {
            ++batches;
            const unsigned lanes = batch.lanes();
            *scalar_batch = batch;
            interpolate_depth(runs, batch);
            interpolate_perspective(runs, batch, *vector);
            interpolate_colors(layout, runs, *vector, batch);
            interpolate_depth_scalar(runs, *scalar_batch);
            interpolate_perspective_scalar(runs, *scalar_batch, *scalar);
            interpolate_colors_scalar(layout, runs, *scalar, *scalar_batch);
            REQUIRE(same_lanes(batch.depth, scalar_batch->depth, lanes));
            interpolate_sample_depths(runs, batch, *vector_depths);
            interpolate_sample_depths_scalar(runs, batch, *scalar_depths);
            for (unsigned i = 0; i < MaxSamples; ++i)
                REQUIRE(same_lanes(vector_depths->of[i], scalar_depths->of[i], lanes));
            REQUIRE(same_lanes(vector->w, scalar->w, lanes));
            REQUIRE(same_colors(batch.primary, scalar_batch->primary, lanes));
            REQUIRE(same_colors(batch.secondary, scalar_batch->secondary, lanes));
            check_color_words(layout, runs, *vector, *scalar_batch);
            check_full_channels(runs, batch);
            REQUIRE(same_lanes(batch.fog_coordinate, scalar_batch->fog_coordinate, lanes));
            for (const unsigned unit : {0u, 1u, 3u}) {
                const auto same = [&] {
                    return same_lanes(vector_coords->s, scalar_coords->s, lanes) &&
                           same_lanes(vector_coords->t, scalar_coords->t, lanes) &&
                           same_lanes(vector_coords->r, scalar_coords->r, lanes);
                };
                interpolate_tex_coords(layout, unit, runs, *vector, batch, *vector_coords);
                interpolate_tex_coords_scalar(
                    layout, unit, runs, *scalar, *scalar_batch, *scalar_coords);
                REQUIRE(same());
                interpolate_directions(layout, unit, runs, *vector, batch, *vector_coords);
                interpolate_directions_scalar(
                    layout, unit, runs, *scalar, *scalar_batch, *scalar_coords);
                REQUIRE(same());
            }
        });
    CHECK(batches > 40);
}

} // namespace

TEST_CASE("vector and scalar interpolation give the same bits with every instruction set") {
    for_each_target(compare_forms);
    compare_forms();
}

TEST_CASE("depth at a pixel is the same whatever path leads there, and rounds the exact plane") {
    Random random(12);
    RecordBuffer buffer;
    const SetupContext setup = context();
    int drawn = 0;
    for (int i = 0; i < 2000; ++i) {
        WindowVertex v[3];
        for (WindowVertex& each : v)
            each = vertex(random.between(0, 60000), random.between(0, 60000), random.unit());
        if (!buffer.triangle(setup, v[0], v[1], v[2])) continue;
        ++drawn;
        const DepthPlane& plane = buffer.record().depth;
        const int x = random.between(-200, 200), y = random.between(-200, 200);
        // Step by step, down and right, and right and down.
        std::int64_t walked = plane.origin;
        for (int step = 0; step < std::abs(x); ++step)
            walked += x < 0 ? -plane.dx : plane.dx;
        for (int step = 0; step < std::abs(y); ++step)
            walked += y < 0 ? -plane.dy : plane.dy;
        REQUIRE(walked == plane.at(x, y));
    }
    CHECK(drawn > 1500);
}

TEST_CASE("depth is within one unit of the true plane, and never outside the vertices' range") {
    Random random(13);
    RecordBuffer buffer;
    const SetupContext setup = context();
    TileCoverage coverage;
    auto batch = std::make_unique<FragmentBatch>();
    for (int i = 0; i < 500; ++i) {
        WindowVertex v[3];
        for (WindowVertex& each : v)
            each = vertex(random.between(0, 16000), random.between(0, 16000), random.unit());
        if (!buffer.triangle(setup, v[0], v[1], v[2])) continue;
        const SetupRecord& record = buffer.record();
        QuadCollector collector(*batch);
        collector.begin_tile({0, 0, 64, 64});
        cover_tile(edge_set(record), {0, 0, 64, 64}, coverage);
        const long double area = static_cast<long double>(v[1].x - v[0].x) * (v[2].y - v[0].y) -
                                 static_cast<long double>(v[2].x - v[0].x) * (v[1].y - v[0].y);
        const auto compare = [&] {
            interpolate_depth(collector.runs(), *batch);
            for (unsigned lane = 0; lane < batch->lanes(); ++lane) {
                if (!batch->live.test(lane)) continue;
                const long double x = (batch->x[lane / 4] + int(lane & 1)) * 256 + 128 - v[0].x;
                const long double y =
                    (batch->y[lane / 4] + int(lane >> 1 & 1)) * 256 + 128 - v[0].y;
                const long double b1 = (x * (v[2].y - v[0].y) - y * (v[2].x - v[0].x)) / area;
                const long double b2 = (y * (v[1].x - v[0].x) - x * (v[1].y - v[0].y)) / area;
                const long double z =
                    (v[0].depth + b1 * (static_cast<long double>(v[1].depth) - v[0].depth) +
                     b2 * (static_cast<long double>(v[2].depth) - v[0].depth)) *
                    0xffffff;
                REQUIRE(std::abs(static_cast<long double>(batch->depth[lane]) - z) < 0.51L);
            }
            collector.clear();
        };
        for (unsigned block = 0; block < coverage.count; ++block)
            collector.add(record, coverage.blocks[block], nullptr, compare);
        compare();
    }
}

TEST_CASE("depth at a sample is within one unit of the true plane at its place") {
    Random random(15);
    RecordBuffer buffer;
    SetupContext setup = context();
    setup.multisample = true;
    auto coverage = std::make_unique<TileSampleCoverage>();
    auto batch = std::make_unique<FragmentBatch>();
    auto collector = std::make_unique<QuadCollector>(*batch);
    collector->begin_tile({0, 0, 64, 64});
    auto depths = std::make_unique<SampleDepths>();
    unsigned compared = 0;
    for (int i = 0; i < 300; ++i) {
        WindowVertex v[3];
        for (WindowVertex& each : v)
            each = vertex(random.between(0, 16000), random.between(0, 16000), random.unit());
        if (!buffer.triangle(setup, v[0], v[1], v[2])) continue;
        const long double area = static_cast<long double>(v[1].x - v[0].x) * (v[2].y - v[0].y) -
                                 static_cast<long double>(v[2].x - v[0].x) * (v[1].y - v[0].y);
        const auto compare = [&] {
            interpolate_sample_depths(collector->runs(), *batch, *depths);
            for (unsigned lane = 0; lane < batch->lanes(); ++lane)
                for (unsigned s = 0; s < MaxSamples; ++s) {
                    if (!batch->samples[s].test(lane)) continue;
                    const SubPixelPoint beside = SamplePositions[s];
                    const long double x =
                        (batch->x[lane / 4] + int(lane & 1)) * 256 + 128 + beside.x - v[0].x;
                    const long double y =
                        (batch->y[lane / 4] + int(lane >> 1 & 1)) * 256 + 128 + beside.y - v[0].y;
                    const long double b1 = (x * (v[2].y - v[0].y) - y * (v[2].x - v[0].x)) / area;
                    const long double b2 = (y * (v[1].x - v[0].x) - x * (v[1].y - v[0].y)) / area;
                    const long double z =
                        (v[0].depth + b1 * (static_cast<long double>(v[1].depth) - v[0].depth) +
                         b2 * (static_cast<long double>(v[2].depth) - v[0].depth)) *
                        0xffffff;
                    ++compared;
                    REQUIRE(std::abs(static_cast<long double>(depths->of[s][lane]) - z) < 0.51L);
                }
            collector->clear();
        };
        cover_tile_samples(buffer.record(), {0, 0, 64, 64}, *coverage);
        for (unsigned block = 0; block < coverage->count; ++block)
            collector->add_samples(buffer.record(), coverage->blocks[block], compare);
        compare();
    }
    CHECK(compared > 100000);
}

TEST_CASE("perspective texture coordinates stay within 2^-17 of the true ones") {
    Random random(14);
    auto planes = std::make_unique<PerspectivePlanes>();
    auto coords = std::make_unique<TexCoordPlanes>();
    auto batch = std::make_unique<FragmentBatch>();
    SetupContext setup = context();
    setup.layout = full_layout();
    RecordBuffer buffer;
    TileCoverage coverage;
    double worst = 0;
    for (int i = 0; i < 300; ++i) {
        WindowVertex v[3];
        for (WindowVertex& each : v)
            each = random_vertex(random, true);
        // Not slivers: their steps are as wrong as their area is small.
        const double area =
            static_cast<double>(double_area({v[0].x, v[0].y}, {v[1].x, v[1].y}, {v[2].x, v[2].y}));
        if (std::abs(area) < 1e8 || !buffer.triangle(setup, v[0], v[1], v[2])) continue;
        QuadCollector collector(*batch);
        collector.begin_tile({0, 0, 128, 128});
        cover_tile(edge_set(buffer.record()), {0, 0, 128, 128}, coverage);
        const auto compare = [&] {
            interpolate_perspective(collector.runs(), *batch, *planes);
            interpolate_tex_coords(setup.layout, 0, collector.runs(), *planes, *batch, *coords);
            for (unsigned lane = 0; lane < batch->lanes(); ++lane) {
                if (!batch->live.test(lane)) continue;
                const double x = (batch->x[lane / 4] + int(lane & 1)) * 256 + 128 - v[0].x;
                const double y = (batch->y[lane / 4] + int(lane >> 1 & 1)) * 256 + 128 - v[0].y;
                const double b1 = (x * (v[2].y - v[0].y) - y * (v[2].x - v[0].x)) / area;
                const double b2 = (y * (v[1].x - v[0].x) - x * (v[1].y - v[0].y)) / area;
                const double weight[3] = {1 - b1 - b2, b1, b2};
                double s = 0, w = 0;
                for (unsigned k = 0; k < 3; ++k) {
                    s += weight[k] * static_cast<double>(v[k].attributes[8]) *
                         static_cast<double>(v[k].inverse_w);
                    w += weight[k] * static_cast<double>(v[k].inverse_w);
                }
                worst = std::max(worst, std::abs(s / w - static_cast<double>(coords->s[lane])));
            }
            collector.clear();
        };
        for (unsigned block = 0; block < coverage.count; ++block)
            collector.add(buffer.record(), coverage.blocks[block], nullptr, compare);
        compare();
    }
    INFO(worst);
    CHECK(worst < 1.0 / (1 << 17));
    CHECK(worst > 0);
}

TEST_CASE("equal vertices give exactly constant attributes, in perspective as well for colours") {
    SetupContext setup = context();
    setup.layout = full_layout();
    RecordBuffer buffer;
    WindowVertex v[3] = {vertex(100, 100, 0.1f, 0.1f),
                         vertex(20000, 300, 0.1f, 0.7f),
                         vertex(500, 30000, 0.1f, 1.3f)};
    for (WindowVertex& each : v)
        each.attributes.fill(0.3f);
    REQUIRE(buffer.triangle(setup, v[0], v[1], v[2]));
    CHECK(buffer.record().constant_color);
    CHECK(buffer.record().color[0] == 77); // 76.5 and a little: 0.3 in binary32 is above.
    CHECK(buffer.record().perspective);

    for (WindowVertex& each : v)
        each.inverse_w = 0.7f;
    REQUIRE(buffer.triangle(setup, v[0], v[1], v[2]));
    CHECK_FALSE(buffer.record().perspective);
    for (unsigned i = 7; i < setup.layout.count; ++i) {
        const AttributePlane plane = buffer.record().plane(i);
        CHECK(static_cast<float>(plane.corner(123, -45)) * plane.scale == 0.3f);
        CHECK(plane.lane_offsets() == std::array<std::int32_t, 4>{});
    }
}

TEST_CASE("the depth offset is m * factor + r * units") {
    SetupContext setup = context();
    setup.primitive.offset_fill = true;
    setup.primitive.offset_factor = 2;
    setup.primitive.offset_units = 5;
    RecordBuffer plain, moved;
    // Over 64 pixels depth rises by 2^-4 in x and falls by 2^-3 in y: m is 2^-9 a pixel.
    const WindowVertex a = vertex(0, 0, 0.5f), b = vertex(64 * 256, 0, 0.5625f),
                       c = vertex(0, 64 * 256, 0.375f);
    REQUIRE(plain.triangle(context(), a, b, c));
    REQUIRE(moved.triangle(setup, a, b, c));
    const double difference =
        static_cast<double>(moved.record().depth.origin - plain.record().depth.origin) / (1 << 24);
    CHECK(difference == Approx(2 * 0xffffff / 512.0 + 5).epsilon(1e-9));
}
