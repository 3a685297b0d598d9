// Windows: primitives of few pixels without blocks. Against edges at each pixel, with each
// instruction set, and how a window's pixels lie in blocks.

#include "model/raster/quad_collector.h"
#include "tests/raster/raster_helpers.h"

#include <algorithm>
#include <memory>

using namespace ffgpu;
using namespace ffgpu::test;

namespace {

std::set<Pixel> pixels_of(const BlockCoverage& block) {
    std::set<Pixel> pixels;
    for (int y = 0; y < BlockSize; ++y)
        for (int x = 0; x < BlockSize; ++x)
            if ((block.mask >> block_bit(x, y) & 1) != 0) pixels.emplace(block.x + x, block.y + y);
    return pixels;
}

// Each pixel once.
std::set<Pixel> pixels_of(const TileCoverage& coverage) {
    std::set<Pixel> pixels;
    for (unsigned i = 0; i < coverage.count; ++i) {
        const BlockCoverage& window = coverage.blocks[i];
        REQUIRE(window.x % 2 == 0);
        REQUIRE(window.y % 2 == 0);
        REQUIRE(window.mask != 0);
        const std::size_t before = pixels.size();
        const std::set<Pixel> more = pixels_of(window);
        pixels.insert(more.begin(), more.end());
        REQUIRE(pixels.size() == before + more.size());
    }
    return pixels;
}

// In the tile, without edge functions' vectors or masks: each pixel's centre and all edges.
std::set<Pixel> pixels_inside(const SetupRecord& record, const Rectangle& tile) {
    std::set<Pixel> pixels;
    const Rectangle area = intersect(record.box, tile);
    for (int y = area.y0; y < area.y1; ++y)
        for (int x = area.x0; x < area.x1; ++x)
            if (record.edges[0].at(x, y) >= 0 && record.edges[1].at(x, y) >= 0 &&
                record.edges[2].at(x, y) >= 0)
                pixels.emplace(x, y);
    return pixels;
}

Rectangle tile_at(int x, int y) {
    return {x & ~63, y & ~63, (x & ~63) + 64, (y & ~63) + 64};
}

// Small triangles, and large ones of which a small scissor leaves little.
bool random_record(Random& random, RecordBuffer& buffer) {
    const bool cut = random.below(3) == 0;
    const int x = random.between(56, 72), y = random.between(56, 72);
    const int size = cut ? 1 << random.between(10, 20) : 256 * random.between(1, 12);
    const SetupContext setup =
        cut ? context({x, y, x + random.between(1, 8), y + random.between(1, 8)}) : context();
    const auto corner = [&] {
        const int px = 256 * x + random.between(-size, size);
        return vertex(px, 256 * y + random.between(-size, size));
    };
    const WindowVertex a = corner(), b = corner(), c = corner();
    return buffer.triangle(setup, a, b, c) && fits_windows(buffer.record());
}

} // namespace

TEST_CASE("windows hold the pixels that lie inside all edges, with each instruction set") {
    for_each_target([] {
        const CoverTileForm form = choose_cover_windows();
        Random random(81);
        RecordBuffer buffer;
        unsigned covered = 0, several = 0;
        TileCoverage coverage, scalar;
        for (int n = 0; n < 40000; ++n) {
            if (!random_record(random, buffer)) continue;
            const SetupRecord& record = buffer.record();
            const Rectangle& box = record.box;
            for (const int x : {box.x0, box.x1 - 1}) {
                const Rectangle tile = tile_at(x, box.y0);
                form(edge_set(record), tile, coverage);
                cover_windows_scalar(edge_set(record), tile, scalar);
                const std::set<Pixel> expected = pixels_inside(record, tile);
                REQUIRE(pixels_of(coverage) == expected);
                REQUIRE(pixels_of(scalar) == expected);
                covered += !expected.empty();
                several += coverage.count > 1;
            }
        }
        CHECK(covered > 10000);
        CHECK(several > 1000);
    });
}

TEST_CASE("primitives fit windows by the quads of their boxes and by their edges") {
    SetupRecord record;
    record.edge_count = 3;
    record.edges = {};
    const auto fits = [&](const Rectangle& box) {
        record.box = box;
        return fits_windows(record);
    };
    CHECK(fits({10, 20, 26, 36}));
    CHECK_FALSE(fits({10, 20, 27, 36}));
    CHECK_FALSE(fits({10, 20, 26, 37}));
    CHECK(fits({11, 21, 26, 36}));
    CHECK_FALSE(fits({11, 21, 27, 36})); // Its first quads begin a pixel before.
    record.edges[2] = {-4000, 681, 0};   // 7 (4000 + 681) is the last that fits 15 bits.
    CHECK(fits({10, 20, 18, 28}));
    record.edges[2].b = -682;
    CHECK_FALSE(fits({10, 20, 18, 28}));
    record.edges[2] = {};
    record.edge_count = 4;
    CHECK_FALSE(fits({10, 20, 18, 28}));
}

TEST_CASE("a window's parts are its pixels in the four blocks that it can touch") {
    Random random(82);
    for (int y = 0; y < 8; y += 2)
        for (int x = 0; x < 8; x += 2)
            for (int n = 0; n < 200; ++n) {
                BlockMask mask = 0;
                for (int i = 0; i < 4; ++i)
                    mask = mask << 16 | static_cast<unsigned>(random.below(1 << 16));
                const BlockCoverage window{
                    static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y), mask};
                const WindowParts parts(window);
                std::set<Pixel> pixels;
                const auto add = [&](std::uint16_t at_x, std::uint16_t at_y, BlockMask part) {
                    pixels.merge(pixels_of(BlockCoverage{at_x, at_y, part}));
                };
                add(0, 0, parts.here);
                add(8, 0, parts.right);
                add(0, 8, parts.up);
                add(8, 8, parts.diagonal);
                REQUIRE(pixels == pixels_of(window));
            }
}

TEST_CASE("a batch ends before a window covers a pixel that is live in it, and before it is full") {
    const auto batch = std::make_unique<FragmentBatch>();
    const auto collector = std::make_unique<QuadCollector>(*batch);
    collector->begin_tile({64, 64, 128, 128});
    RecordBuffer buffer;
    const SetupRecord& record = buffer.record();
    unsigned flushes = 0;
    const auto add = [&](int x, int y, BlockMask mask) {
        collector->add_window(
            record, {static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y), mask}, [&] {
                ++flushes;
                collector->clear();
            });
    };
    const auto pixel = [](int x, int y) { return BlockMask{1} << block_bit(x, y); };
    add(70, 70, pixel(0, 0) | pixel(7, 7)); // Pixels (70, 70) and (77, 77), two blocks.
    add(70, 70, pixel(1, 0) | pixel(6, 7)); // Beside both.
    CHECK(flushes == 0);
    CHECK(batch->quad_count == 4);
    add(76, 76, pixel(1, 1));
    CHECK(flushes == 1);
    // A block that takes pixels of windows in block order sees them too.
    collector->add(record, {72, 72, pixel(5, 5)}, nullptr, [&] {
        ++flushes;
        collector->clear();
    });
    CHECK(flushes == 2);
    CHECK(batch->quad_count == 1);
    for (int i = 0; i < 3; ++i)
        add(80 + 8 * i, 80, FullBlock);
    CHECK(flushes == 2);
    CHECK(batch->quad_count == 49);
    add(120, 120, FullBlock);
    CHECK(flushes == 3);
    CHECK(batch->quad_count == 16);
}
