#include "tests/raster/raster_helpers.h"

#include <algorithm>
#include <map>
#include <set>

#include <catch2/catch.hpp>

using namespace ffgpu;
using namespace ffgpu::test;

namespace {

bool same(const TileCoverage& a, const TileCoverage& b) {
    if (a.count != b.count) return false;
    for (unsigned i = 0; i < a.count; ++i)
        if (a.blocks[i].x != b.blocks[i].x || a.blocks[i].y != b.blocks[i].y ||
            a.blocks[i].mask != b.blocks[i].mask)
            return false;
    return true;
}

// A vertex somewhere; every other one on the grid of pixel centres and corners, where the ties are.
WindowVertex random_vertex(Random& random, int low, int high) {
    int x = random.between(low, high), y = random.between(low, high);
    if (random.below(2)) x &= ~127, y &= ~127;
    return vertex(x, y);
}

} // namespace

TEST_CASE("a mesh of random triangles covers each pixel exactly once") {
    Random random(1);
    constexpr int Cells = MeshCells;
    for (int round = 0; round < 20; ++round) {
        const std::vector<WindowVertex> points = random_mesh(random, round % 2 ? 128 : 1);
        std::map<Pixel, int> times;
        RecordBuffer buffer;
        const auto add = [&](int a, int b, int c) {
            const auto at = [&](int i) -> const WindowVertex& {
                return points[static_cast<std::size_t>(i)];
            };
            if (!buffer.triangle(context(), at(a), at(b), at(c))) return;
            for (const Pixel& pixel : covered_pixels(buffer.record()))
                ++times[pixel];
        };
        for (int j = 0; j < Cells; ++j)
            for (int i = 0; i < Cells; ++i) {
                const int a = j * (Cells + 1) + i, b = a + 1, c = a + Cells + 1, d = c + 1;
                if (random.below(2)) {
                    add(a, b, d); // Either way round: the rule does not know which.
                    add(a, d, c);
                } else {
                    add(b, a, c);
                    add(b, c, d);
                }
            }
        REQUIRE(times.size() == 240u * 240u);
        for (const auto& [pixel, count] : times)
            if (count != 1) FAIL("pixel " << pixel.first << ' ' << pixel.second << ' ' << count);
    }
}

TEST_CASE("a centre on a left or lower edge is inside, on a right or upper edge outside") {
    constexpr int Centre = 128;
    RecordBuffer buffer;
    // The box with corners on the centres of pixels (2, 3) and (6, 7), as two triangles.
    const WindowVertex a = vertex(2 * 256 + Centre, 3 * 256 + Centre);
    const WindowVertex b = vertex(6 * 256 + Centre, 3 * 256 + Centre);
    const WindowVertex c = vertex(6 * 256 + Centre, 7 * 256 + Centre);
    const WindowVertex d = vertex(2 * 256 + Centre, 7 * 256 + Centre);
    std::multiset<Pixel> pixels;
    for (const auto& [p, q, r] : {std::tuple{&a, &b, &c}, std::tuple{&a, &c, &d}}) {
        REQUIRE(buffer.triangle(context(), *p, *q, *r));
        pixels.merge(covered_pixels(buffer.record()));
    }
    std::multiset<Pixel> expected;
    for (int y = 3; y < 7; ++y)
        for (int x = 2; x < 6; ++x)
            expected.emplace(x, y);
    CHECK(pixels == expected);
}

TEST_CASE("the vector form covers what the scalar form covers") {
    Random random(2);
    RecordBuffer buffer;
    TileCoverage vector, scalar;
    constexpr int Limit = GuardBand * 256;
    int drawn = 0;
    for (int i = 0; i < 4000; ++i) {
        const int reach = i % 3 == 0 ? Limit : 256 * 256;
        const int low = i % 3 == 0 ? -Limit : -20 * 256;
        SetupContext setup = context({3, 5, 250, 241});
        if (i % 4 == 3) setup.primitive.line_width = static_cast<float>(1 + i % 7);
        const WindowVertex a = random_vertex(random, low, reach);
        const WindowVertex b = random_vertex(random, low, reach);
        const WindowVertex c = random_vertex(random, low, reach);
        const Primitive line{.shape = PrimitiveShape::Line, .vertices = {&a, &b}};
        if (!(i % 4 == 3 ? buffer.set_up(setup, line) : buffer.triangle(setup, a, b, c))) continue;
        ++drawn;
        const int size = 8 * random.between(2, 16);
        const int x = random.below(256 / size + 1) * size, y = random.below(256 / size + 1) * size;
        const Rectangle tile{x, y, x + size, y + size};
        cover_tile(edge_set(buffer.record()), tile, vector);
        cover_tile_scalar(edge_set(buffer.record()), tile, scalar);
        REQUIRE(same(vector, scalar));
        if (scalar.count != 0) REQUIRE(may_touch(buffer.record(), tile));
    }
    CHECK(drawn > 2000);
}

TEST_CASE("small triangles: each instruction set covers what the scalar form covers") {
    for_each_target([] {
        const CoverTileForm form = choose_cover_tile();
        Random random(7);
        RecordBuffer buffer;
        TileCoverage vector, scalar;
        int covering = 0, blocks = 0;
        for (int i = 0; i < 6000; ++i) {
            const int x = random.between(0, 64 * 256), y = random.between(0, 64 * 256);
            const int reach = 128 << (i % 6); // up to what does not fit 16 bits
            const auto near = [&] {
                const WindowVertex v = random_vertex(random, -reach, reach);
                return vertex(x + v.x, y + v.y);
            };
            const WindowVertex a = near(), b = near(), c = near();
            if (!buffer.triangle(context({3, 5, 50, 61}), a, b, c)) continue;
            const Rectangle tile{0, 0, 64, 64};
            form(edge_set(buffer.record()), tile, vector);
            cover_tile_scalar(edge_set(buffer.record()), tile, scalar);
            REQUIRE(same(vector, scalar));
            covering += scalar.count != 0;
            blocks += scalar.count > 1;
        }
        CHECK(covering > 2000);
        CHECK(blocks > 1000);
    });
}

TEST_CASE("a triangle that reaches the guard band on all sides fills the window") {
    constexpr int Limit = GuardBand * 256;
    RecordBuffer buffer;
    REQUIRE(buffer.triangle(
        context(), vertex(Limit, Limit), vertex(-Limit, Limit), vertex(Limit, -Limit)));
    CHECK(covered_pixels(buffer.record()).size() == 256u * 256u);
}

TEST_CASE("triangles without area or without a centre make no record") {
    RecordBuffer buffer;
    const SetupContext setup = context();
    CHECK_FALSE(buffer.triangle(setup, vertex(0, 0), vertex(512, 512), vertex(5120, 5120)));
    CHECK_FALSE(buffer.triangle(setup, vertex(130, 130), vertex(300, 130), vertex(130, 300)));
    CHECK(buffer.triangle(setup, vertex(128, 128), vertex(300, 128), vertex(128, 300)));
    CHECK_FALSE(buffer.triangle(setup, vertex(-900, 0), vertex(-300, 0), vertex(-300, 900)));
}

TEST_CASE("a small triangle between the centres of its box is told, one on a centre is not") {
    Random random(5);
    RecordBuffer buffer;
    int between = 0, covering = 0, larger = 0;
    for (int i = 0; i < 20000; ++i) {
        const int x = random.between(0, 40 * 256), y = random.between(0, 40 * 256);
        const int reach = 64 << (i % 4);
        const auto near = [&] {
            const WindowVertex v = random_vertex(random, -reach, reach);
            return vertex(std::clamp(x + v.x, 0, 1 << 16), std::clamp(y + v.y, 0, 1 << 16));
        };
        const WindowVertex a = near(), b = near(), c = near();
        if (!buffer.triangle(context(), a, b, c)) continue;
        const Rectangle& box = buffer.record().box;
        const bool small = box.width() <= 2 && box.height() <= 2;
        const bool covers = !covered_pixels(buffer.record()).empty();
        REQUIRE(buffer.record().covers_nothing == (small && !covers));
        ++(!small ? larger : covers ? covering : between);
    }
    CHECK(between > 1000);
    CHECK(covering > 1000);
    CHECK(larger > 1000);
}

TEST_CASE("a batch never holds a pixel twice, and keeps every pixel and the order") {
    Random random(4);
    const Rectangle tile{64, 64, 128, 128};
    auto batch = std::make_unique<FragmentBatch>();
    auto collector = std::make_unique<QuadCollector>(*batch);
    collector->begin_tile(tile);
    std::vector<RecordBuffer> buffers(40);
    std::map<Pixel, std::vector<std::uint32_t>> expected, found;
    const auto flush = [&] {
        std::set<Pixel> live;
        unsigned run = 0;
        for (unsigned lane = 0; lane < batch->lanes(); ++lane) {
            const unsigned quad = lane / 4;
            while (run + 1 < collector->runs().size() &&
                   collector->runs()[run + 1].first_quad <= quad)
                ++run;
            REQUIRE(collector->runs()[run].record->key == batch->primitive[quad]);
            if (!batch->live.test(lane)) continue;
            const Pixel pixel{batch->x[quad] + static_cast<int>(lane & 1),
                              batch->y[quad] + static_cast<int>(lane >> 1 & 1)};
            REQUIRE(live.insert(pixel).second);
            found[pixel].push_back(batch->primitive[quad]);
        }
        for (unsigned lane = batch->lanes(); lane < BatchFragments; ++lane)
            REQUIRE_FALSE(batch->live.test(lane));
        collector->clear();
    };
    TileCoverage coverage;
    for (std::uint32_t key = 0; key < buffers.size(); ++key) {
        const int size = key % 5 == 0 ? 80 * 256 : 9 * 256;
        const int x = random.between(64, 120) * 256, y = random.between(64, 120) * 256;
        const auto corner = [&] { return vertex(x + random.below(size), y + random.below(size)); };
        SetupRecord& record = buffers[key].record();
        if (!buffers[key].triangle(context(), corner(), corner(), corner(), key)) continue;
        cover_tile(edge_set(record), tile, coverage);
        for_each_pixel(coverage, [&](int px, int py) { expected[{px, py}].push_back(key); });
        for (unsigned i = 0; i < coverage.count; ++i)
            collector->add(record, coverage.blocks[i], nullptr, flush);
    }
    flush();
    CHECK(found == expected);
}

TEST_CASE("blocks are touched that the box meets and no edge rules out as a whole") {
    Random random(7);
    RecordBuffer buffer;
    unsigned empty = 0;
    for (int round = 0; round < 3000; ++round) {
        const int size = 256 * (round % 3 == 0 ? 200 : 20);
        const WindowVertex a = random_vertex(random, 0, 256 * 200);
        const auto near = [&] {
            const int x = random.between(-size, size);
            return vertex(a.x + x, a.y + random.between(-size, size));
        };
        const WindowVertex b = near(), c = near();
        if (!buffer.triangle(context(), a, b, c)) continue;
        const SetupRecord& record = buffer.record();
        std::set<Pixel> blocks;
        for (const Pixel& pixel : covered_pixels(record))
            blocks.insert({pixel.first & ~7, pixel.second & ~7});
        // By each pixel of a block: an edge rules it out that has no pixel of it inside.
        std::uint32_t touched = 0;
        for (int y = record.box.y0 & ~7; y < record.box.y1; y += 8)
            for (int x = record.box.x0 & ~7; x < record.box.x1; x += 8) {
                bool in_all = true;
                for (unsigned e = 0; e < record.edge_count; ++e) {
                    bool any = false;
                    for (int i = 0; i < 64; ++i)
                        any = any || record.edges[e].at(x + i % 8, y + i / 8) >= 0;
                    in_all = in_all && any;
                }
                touched += in_all;
            }
        CHECK(touched_blocks(edge_set(record)) == touched);
        CHECK(touched >= blocks.size());
        empty += touched > blocks.size();
    }
    CHECK(empty > 100);
}
