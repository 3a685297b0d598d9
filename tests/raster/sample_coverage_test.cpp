#include "model/raster/sample_coverage.h"
#include "tests/raster/raster_helpers.h"

#include <array>
#include <map>
#include <tuple>
#include <utility>

#include <catch2/catch.hpp>

using namespace ffgpu;
using namespace ffgpu::test;

namespace {

using Sample = std::tuple<int, int, unsigned>; // pixel, number

SetupContext sampled_context(Rectangle clip = {0, 0, 256, 256}) {
    SetupContext result = context(clip);
    result.multisample = true;
    return result;
}

SubPixelPoint place(const Sample& sample) {
    const auto& [x, y, i] = sample;
    return {256 * x + 128 + SamplePositions[i].x, 256 * y + 128 + SamplePositions[i].y};
}

template <class Visit>
void for_each_sample(const TileSampleCoverage& coverage, Visit&& visit) {
    for (unsigned n = 0; n < coverage.count; ++n)
        for (unsigned i = 0; i < MaxSamples; ++i)
            for (int y = 0; y < BlockSize; ++y)
                for (int x = 0; x < BlockSize; ++x)
                    if (coverage.blocks[n].masks[i] >> block_bit(x, y) & 1)
                        visit(Sample{coverage.blocks[n].x + x, coverage.blocks[n].y + y, i});
}

// The samples that a record covers within [0, 256)^2, taken tile by tile.
std::set<Sample> covered_samples(const SetupRecord& record, int tile_size = 64) {
    std::set<Sample> samples;
    auto coverage = std::make_unique<TileSampleCoverage>();
    for (int y = 0; y < 256; y += tile_size)
        for (int x = 0; x < 256; x += tile_size) {
            cover_tile_samples(record, {x, y, x + tile_size, y + tile_size}, *coverage);
            for_each_sample(*coverage,
                            [&](const Sample& sample) { REQUIRE(samples.insert(sample).second); });
        }
    return samples;
}

template <class Visit>
void for_all_samples(Visit&& visit) {
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 256; ++x)
            for (unsigned i = 0; i < MaxSamples; ++i)
                visit(Sample{x, y, i});
}

// The rule itself, from the corners: inside, or on a left or lower edge.
bool inside_polygon(std::vector<SubPixelPoint> corners, SubPixelPoint at) {
    std::int64_t twice_area = 0;
    for (std::size_t i = 0; i + 2 < corners.size(); ++i)
        twice_area += double_area(corners[0], corners[i + 1], corners[i + 2]);
    if (twice_area < 0) std::reverse(corners.begin(), corners.end());
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const SubPixelPoint p = corners[i], q = corners[(i + 1) % corners.size()];
        const std::int64_t a = p.y - q.y, b = q.x - p.x;
        const std::int64_t e = a * (at.x - p.x) + b * (at.y - p.y);
        if (e < 0 || (e == 0 && !(a > 0 || (a == 0 && b > 0)))) return false;
    }
    return true;
}

WindowVertex random_vertex(Random& random, int low, int high) {
    int x = random.between(low, high), y = random.between(low, high);
    if (random.below(2)) x &= ~31, y &= ~31; // where the samples are
    return vertex(x, y);
}

bool same(const TileSampleCoverage& a, const TileSampleCoverage& b) {
    if (a.count != b.count) return false;
    for (unsigned i = 0; i < a.count; ++i)
        if (a.blocks[i].x != b.blocks[i].x || a.blocks[i].y != b.blocks[i].y ||
            a.blocks[i].masks != b.blocks[i].masks)
            return false;
    return true;
}

} // namespace

TEST_CASE("a triangle covers exactly the samples inside it") {
    Random random(31);
    RecordBuffer buffer;
    for (int round = 0; round < 60; ++round) {
        const int size = round % 3 == 0 ? 300 : round % 3 == 1 ? 3000 : 70000;
        const int x = random.below(60000) - 2000, y = random.below(60000) - 2000;
        const auto corner = [&] {
            const WindowVertex v = random_vertex(random, 0, size);
            return vertex(x + v.x, y + v.y);
        };
        const WindowVertex a = corner(), b = corner(), c = corner();
        const std::vector<SubPixelPoint> corners{{a.x, a.y}, {b.x, b.y}, {c.x, c.y}};
        std::set<Sample> expected;
        if (double_area(corners[0], corners[1], corners[2]) != 0)
            for_all_samples([&](const Sample& sample) {
                if (inside_polygon(corners, place(sample))) expected.insert(sample);
            });
        std::set<Sample> covered;
        if (buffer.triangle(sampled_context(), a, b, c)) covered = covered_samples(buffer.record());
        REQUIRE((covered == expected));
    }
}

TEST_CASE("a mesh of random triangles covers each sample exactly once") {
    Random random(32);
    constexpr int Cells = MeshCells;
    for (int round = 0; round < 6; ++round) {
        const std::vector<WindowVertex> points = random_mesh(random, round % 2 ? 32 : 1);
        std::map<Sample, int> times;
        RecordBuffer buffer;
        const auto add = [&](int a, int b, int c) {
            const auto at = [&](int i) -> const WindowVertex& {
                return points[static_cast<std::size_t>(i)];
            };
            if (!buffer.triangle(sampled_context(), at(a), at(b), at(c))) return;
            for (const Sample& sample : covered_samples(buffer.record()))
                ++times[sample];
        };
        for (int j = 0; j < Cells; ++j)
            for (int i = 0; i < Cells; ++i) {
                const int a = j * (Cells + 1) + i, b = a + 1, c = a + Cells + 1, d = c + 1;
                add(a, b, d);
                add(a, d, c);
            }
        REQUIRE(times.size() == 240u * 240u * MaxSamples);
        for (const auto& [sample, count] : times)
            if (count != 1) FAIL("a sample was covered " << count << " times");
    }
}

TEST_CASE("the vector form covers the samples that the scalar form covers") {
    Random random(33);
    RecordBuffer buffer;
    auto vector = std::make_unique<TileSampleCoverage>();
    auto scalar = std::make_unique<TileSampleCoverage>();
    constexpr int Limit = GuardBand * 256;
    int drawn = 0;
    for (int i = 0; i < 2000; ++i) {
        const int reach = i % 3 == 0 ? Limit : 256 * 256;
        const int low = i % 3 == 0 ? -Limit : -20 * 256;
        SetupContext setup = sampled_context({3, 5, 250, 241});
        setup.primitive.line_width = 0.5f + static_cast<float>(i % 70) / 8;
        setup.primitive.point_sprite = i % 2 != 0;
        const WindowVertex a = random_vertex(random, low, reach);
        const WindowVertex b = random_vertex(random, low, reach);
        const WindowVertex c = random_vertex(random, low, reach);
        Primitive primitive{.shape = PrimitiveShape::Triangle, .vertices = {&a, &b, &c}};
        if (i % 4 == 3) primitive = {.shape = PrimitiveShape::Line, .vertices = {&a, &b}};
        if (i % 16 == 7) primitive = {.shape = PrimitiveShape::Point, .vertices = {&a}};
        if (!buffer.set_up(setup, primitive)) continue;
        ++drawn;
        const int size = 8 * random.between(2, 16);
        const int x = random.below(256 / size + 1) * size, y = random.below(256 / size + 1) * size;
        const Rectangle tile{x, y, x + size, y + size};
        cover_tile_samples(buffer.record(), tile, *vector);
        cover_tile_samples_scalar(buffer.record(), tile, *scalar);
        REQUIRE(same(*vector, *scalar));
        if (scalar->count != 0) REQUIRE(may_touch(buffer.record(), tile));
    }
    CHECK(drawn > 1000);
}

TEST_CASE("a multisampled point is a circle, a sprite a square") {
    Random random(34);
    RecordBuffer buffer;
    for (int round = 0; round < 60; ++round) {
        WindowVertex v = vertex(random.between(-500, 66000), random.between(-500, 66000));
        if (round % 4 == 0) v = vertex(v.x & ~31, v.y & ~31);
        const int half = random.between(1, 12 * 256);
        v.point_size = static_cast<float>(half) / 128;
        SetupContext setup = sampled_context();
        setup.primitive.point_sprite = round % 2 == 1;
        setup.primitive.point_smooth = round % 3 == 1; // of no effect
        setup.primitive.point_fade_threshold = 0;
        std::set<Sample> expected;
        for_all_samples([&](const Sample& sample) {
            const std::int64_t dx = place(sample).x - v.x, dy = place(sample).y - v.y;
            const bool inside = setup.primitive.point_sprite
                                    ? dx >= -half && dx < half && dy >= -half && dy < half
                                    : dx * dx + dy * dy <= std::int64_t{half} * half;
            if (inside) expected.insert(sample);
        });
        std::set<Sample> covered;
        if (buffer.set_up(setup, {.shape = PrimitiveShape::Point, .vertices = {&v}}))
            covered = covered_samples(buffer.record());
        REQUIRE((covered == expected));
    }
}

TEST_CASE("a multisampled point below the fade threshold has its size, and fades") {
    SetupContext setup = sampled_context();
    setup.layout.color = 0;
    setup.layout.count = 4;
    setup.primitive.point_fade_threshold = 8;
    WindowVertex v = vertex(5000, 5000);
    v.attributes[3] = 2; // clamped first
    const auto samples_and_alpha = [&](float size) {
        v.point_size = size;
        RecordBuffer buffer;
        REQUIRE(buffer.set_up(setup, {.shape = PrimitiveShape::Point, .vertices = {&v}}));
        return std::pair{covered_samples(buffer.record()).size(), int{buffer.record().color[3]}};
    };
    const auto [samples, alpha] = samples_and_alpha(8);
    CHECK(alpha == 255);
    CHECK((samples_and_alpha(4) == std::pair{samples, 64}));
    setup.multisample = false;
    v.point_size = 4;
    RecordBuffer buffer;
    REQUIRE(buffer.set_up(setup, {.shape = PrimitiveShape::Point, .vertices = {&v}}));
    CHECK(buffer.record().box.width() == 4);
    CHECK(buffer.record().color[3] == 255);
}

TEST_CASE("a multisampled line is the rectangle of its width") {
    SetupContext setup = sampled_context();
    setup.primitive.line_width = 3;
    RecordBuffer buffer;
    const auto covered = [&](WindowVertex a, WindowVertex b) {
        REQUIRE(buffer.set_up(setup, {.shape = PrimitiveShape::Line, .vertices = {&a, &b}}));
        return covered_samples(buffer.record());
    };
    SECTION("level") {
        std::set<Sample> expected; // rows 9.5 to 12.5, columns 10.5 to 30.25
        for_all_samples([&](const Sample& sample) {
            const SubPixelPoint at = place(sample);
            if (at.x >= 10 * 256 + 128 && at.x < 30 * 256 + 64 && at.y >= 9 * 256 + 128 &&
                at.y < 12 * 256 + 128)
                expected.insert(sample);
        });
        CHECK((covered(vertex(10 * 256 + 128, 11 * 256), vertex(30 * 256 + 64, 11 * 256)) ==
               expected));
        CHECK((covered(vertex(30 * 256 + 64, 11 * 256), vertex(10 * 256 + 128, 11 * 256)) ==
               expected));
    }
    SECTION("slanted: its area in samples") {
        const auto samples = covered(vertex(20 * 256, 30 * 256), vertex(140 * 256, 120 * 256));
        CHECK(samples.size() == Approx(150 * 3 * 4).epsilon(0.01));
    }
    SECTION("without length it covers nothing") {
        const WindowVertex a = vertex(1000, 1000);
        CHECK_FALSE(buffer.set_up(setup, {.shape = PrimitiveShape::Line, .vertices = {&a, &a}}));
    }
}

TEST_CASE("a batch never holds a sample twice, and keeps every sample and the order") {
    Random random(35);
    const Rectangle tile{64, 64, 128, 128};
    auto batch = std::make_unique<FragmentBatch>();
    auto collector = std::make_unique<QuadCollector>(*batch);
    collector->begin_tile(tile);
    std::vector<RecordBuffer> buffers(40);
    std::map<Sample, std::vector<std::uint32_t>> expected, found;
    const auto flush = [&] {
        std::set<Sample> live;
        REQUIRE(batch->live == any_sample(batch->samples));
        for (unsigned lane = 0; lane < BatchFragments; ++lane)
            for (unsigned i = 0; i < MaxSamples; ++i) {
                if (!batch->samples[i].test(lane)) continue;
                REQUIRE(lane < batch->lanes());
                const Sample sample{batch->x[lane / 4] + static_cast<int>(lane & 1),
                                    batch->y[lane / 4] + static_cast<int>(lane >> 1 & 1),
                                    i};
                REQUIRE(live.insert(sample).second);
                found[sample].push_back(batch->primitive[lane / 4]);
            }
        collector->clear();
    };
    auto coverage = std::make_unique<TileSampleCoverage>();
    for (std::uint32_t key = 0; key < buffers.size(); ++key) {
        const int size = key % 5 == 0 ? 80 * 256 : 9 * 256;
        const int x = random.between(64, 120) * 256, y = random.between(64, 120) * 256;
        const auto corner = [&] { return vertex(x + random.below(size), y + random.below(size)); };
        SetupRecord& record = buffers[key].record();
        if (!buffers[key].triangle(sampled_context(), corner(), corner(), corner(), key)) continue;
        cover_tile_samples(record, tile, *coverage);
        for_each_sample(*coverage, [&](const Sample& sample) { expected[sample].push_back(key); });
        for (unsigned i = 0; i < coverage->count; ++i)
            collector->add_samples(record, coverage->blocks[i], flush);
    }
    flush();
    CHECK((found == expected));
}

TEST_CASE("the halves of a quad share a batch, and the pixels of their common edge") {
    auto batch = std::make_unique<FragmentBatch>();
    auto collector = std::make_unique<QuadCollector>(*batch);
    collector->begin_tile({0, 0, 64, 64});
    const WindowVertex a = vertex(256, 256), b = vertex(2560, 256), c = vertex(2560, 2560),
                       d = vertex(256, 2560);
    std::array<RecordBuffer, 2> buffers;
    REQUIRE(buffers[0].triangle(sampled_context(), a, b, c));
    REQUIRE(buffers[1].triangle(sampled_context(), a, c, d));
    auto coverage = std::make_unique<TileSampleCoverage>();
    for (RecordBuffer& buffer : buffers) {
        cover_tile_samples(buffer.record(), {0, 0, 64, 64}, *coverage);
        for (unsigned i = 0; i < coverage->count; ++i)
            collector->add_samples(
                buffer.record(), coverage->blocks[i], [] { FAIL("the batch was ended"); });
    }
    unsigned samples = 0;
    for (const FragmentMask& mask : batch->samples)
        samples += mask.count();
    CHECK(samples == 9 * 9 * MaxSamples);
    CHECK(batch->live.count() > 9 * 9); // Pixels of the diagonal are live twice.
}
