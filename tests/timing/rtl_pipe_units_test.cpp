// What the units of a machine take that is built as the fragment pipe in RTL, against closed forms:
// the walk over whole tiles, attributes, texels one by one, targets without caches.

#include "tests/timing/front_end_scenes.h"
#include "tests/timing/textured_draws.h"

#include <algorithm>
#include <random>

#include <catch2/catch.hpp>

namespace ffgpu::timing {
namespace {

constexpr std::uint64_t TileBlocks = 16, BlockQuads = 16;

TimingConfig tile_walker() {
    TimingConfig config = wide_front_end();
    config.raster.traversal = Traversal::Nested;
    config.raster.walk = Walk::Tiles;
    config.raster.piece_cycles = 1;
    return config;
}

struct Pieces {
    WorkBin bin;
    std::uint64_t cycles = 0; // of the walk
};

// Boxes somewhere in 512 x 512 pixels, each with quads in some of its blocks, and more blocks that
// only edges touch.
Pieces random_pieces(std::uint32_t seed, unsigned count) {
    std::mt19937 engine(seed);
    const auto random = [&] { return static_cast<std::uint32_t>(engine()); };
    Pieces made;
    WorkDraw& draw = made.bin.draws.emplace_back();
    draw.state = std::make_shared<Registers>();
    draw.geometry.vertex_bytes = 16;
    draw.geometry.vertices = {0};
    WorkBatch& batch = made.bin.tiles.emplace_back().batches.emplace_back();
    for (unsigned i = 0; i < count; ++i) {
        PieceBox box;
        box.x0 = static_cast<std::uint16_t>(random() % 400);
        box.y0 = static_cast<std::uint16_t>(random() % 400);
        box.x1 = static_cast<std::uint16_t>(box.x0 + 1 + random() % 100);
        box.y1 = static_cast<std::uint16_t>(box.y0 + 1 + random() % 100);
        std::uint32_t blocks = 0;
        for (std::uint32_t y = box.y0 / 8; y <= (box.y1 - 1u) / 8; ++y)
            for (std::uint32_t x = box.x0 / 8; x <= (box.x1 - 1u) / 8; ++x) {
                const std::uint32_t kind = random() % 3;
                blocks += kind != 0;
                if (kind != 2) continue;
                WorkQuad quad{};
                quad.piece = i;
                quad.x = static_cast<std::uint16_t>(std::max<std::uint32_t>(8 * x, box.x0) & ~1u);
                quad.y = static_cast<std::uint16_t>(std::max<std::uint32_t>(8 * y, box.y0) & ~1u);
                quad.covered = quad.after_early_depth = quad.after_coverage = 15;
                quad.after_alpha = quad.after_stencil = quad.after_depth = 15;
                batch.quads.push_back(quad);
            }
        box.touched_blocks = blocks;
        box.handed_on = true;
        draw.geometry.pieces.push_back(box);
        const std::uint64_t tiles =
            ((box.x1 - 1u) / 32 - box.x0 / 32u + 1) * ((box.y1 - 1u) / 32 - box.y0 / 32u + 1);
        made.cycles += 1 + tiles * (1 + TileBlocks) + blocks * BlockQuads;
    }
    draw.geometry.primitives = {{.pieces = count}};
    return made;
}

TEST_CASE(
    "a walk over tiles takes a cycle a piece, tile and block, and sixteen one that is touched") {
    const Pieces few = random_pieces(1, 40), many = random_pieces(1, 90);
    const TimingConfig config = tile_walker();
    const Figures less = run(config, few.bin), more = run(config, many.bin);
    CHECK(more.at("raster_busy_cycles") - less.at("raster_busy_cycles") ==
          many.cycles - few.cycles);
    CHECK(run(config, few.bin, {9}) == less);
    CHECK(run(config, few.bin, {0, Pace::EveryCycle}) == less);
}

TEST_CASE(
    "a piece without quads is walked by a rasterizer that walks tiles, unless set-up drops it") {
    WorkBin bin = random_pieces(2, 10).bin;
    const Figures without = run(tile_walker(), bin);
    PieceBox& piece = bin.draws[0].geometry.pieces.emplace_back(PieceBox{8, 8, 40, 24});
    ++bin.draws[0].geometry.primitives[0].pieces;
    CHECK(run(tile_walker(), bin).at("raster_busy_cycles") ==
          without.at("raster_busy_cycles") + 1); // The token of the draw's end.
    piece.handed_on = true;
    CHECK(run(tile_walker(), bin).at("raster_busy_cycles") ==
          without.at("raster_busy_cycles") + 1 + 2 * (1 + TileBlocks));
}

// All quads belong to one piece with so many attributes.
WorkBin with_values(std::uint8_t values, std::uint8_t divisors, bool perspective) {
    WorkBin bin = textured_draw(1);
    PieceBox box{0, 0, FillSize, FillSize};
    box.values = values;
    box.divisors = divisors;
    box.perspective = perspective;
    bin.draws[0].geometry.vertices = {0};
    bin.draws[0].geometry.pieces = {box};
    bin.draws[0].geometry.primitives = {{.pieces = 1}};
    return bin;
}

TEST_CASE("an interpolator takes a quad for each of its values and w, and divides beside that") {
    TimingConfig config = wide_machine(1);
    config.interpolator.value_cycles = 1;
    config.interpolator.divide_latency = 13;
    const auto busy = [&](std::uint8_t values, std::uint8_t divisors, bool perspective) {
        return run(config, with_values(values, divisors, perspective))
            .at("interpolator_busy_cycles");
    };
    CHECK(busy(0, 0, false) == FillQuads);
    CHECK(busy(6, 0, false) == 6 * FillQuads);
    CHECK(busy(6, 1, true) == 7 * FillQuads);
    CHECK(busy(6, 3, true) == 7 * FillQuads);
    const Figures figures = run(config, with_values(2, 1, true));
    CHECK(run(config, with_values(2, 1, true), {5}) == figures);
    CHECK(run(config, with_values(2, 1, true), {0, Pace::EveryCycle}) == figures);
    // Eight quads whose divisors are made hide their latency, one does not.
    config.interpolator.divide_queue = 1;
    CHECK(run(config, with_values(2, 1, true)).at("total_cycles") > 13 * FillQuads);
}

// Items that a queue holds, on average.
double held(const Figures& figures, const std::string& queue) {
    return static_cast<double>(figures.at("queue_" + queue + "_item_cycles")) /
           static_cast<double>(figures.at("total_cycles"));
}

// Behind the interpolator a quad takes sixteen cycles. The first one's values are collected but for
// the last.
TEST_CASE("between interpolator and texture unit there are places for values") {
    const std::uint32_t places = 7;
    for (const std::uint32_t values : {1u, 2u, 3u, 5u, 9u}) {
        TimingConfig config = wide_machine(1);
        config.interpolator.value_cycles = 1;
        config.texture.rate = TexelRate::Texels;
        const WorkBin bin = with_values(static_cast<std::uint8_t>(values), 1, true);
        CHECK(held(run(config, bin), "interpolator_to_depth") > places + 1);
        config.interpolator.value_places = places;
        const Figures figures = run(config, bin);
        const std::uint32_t quads = (places + values - 1) / values;
        CAPTURE(values, quads);
        CHECK(held(figures, "interpolator_to_depth") <= quads);
        // Between two of them w is taken, and the values that found no place.
        CHECK(held(figures, "interpolator_to_depth") > quads - (values + 3) / 16.0);
        CHECK(run(config, bin, {5}) == figures);
        CHECK(run(config, bin, {0, Pace::EveryCycle}) == figures);
    }
}

TEST_CASE("a walk over tiles takes a piece when the last quad of the one before has left") {
    TimingConfig config = tile_walker();
    config.raster.latency = 3;
    config.raster.queue = 2; // four places: three registers, and one of them is handed on
    config.fragment.quad_cycles = 64;
    config.fragment.queue = config.fragment.pipe_queue = 1;
    config.depth_cache.fragment_fifo = config.texel_cache.fragment_fifo = 1;
    // A quad a piece.
    WorkBin bin = random_pieces(3, 200).bin;
    WorkBatch& batch = bin.tiles[0].batches[0];
    const auto same_piece = [](const WorkQuad& one, const WorkQuad& two) {
        return one.piece == two.piece;
    };
    batch.quads.erase(std::unique(batch.quads.begin(), batch.quads.end(), same_piece),
                      batch.quads.end());
    for (PieceBox& box : bin.draws[0].geometry.pieces)
        box = {box.x0, box.y0, box.x0, box.y0, 1};
    const Figures figures = run(config, bin);
    CHECK(held(figures, "raster_to_depth") < 3);
    CHECK(held(figures, "raster_to_depth") > 2);
    CHECK(run(config, bin, {5}) == figures);
    CHECK(run(config, bin, {0, Pace::EveryCycle}) == figures);
}

TEST_CASE(
    "a texture unit that takes texels one by one one by one takes sixteen cycles a bilinear quad") {
    TimingConfig config = wide_machine(1);
    config.texture.rate = TexelRate::Texels;
    for (const unsigned textures : {1u, 2u}) {
        const Figures figures = run(config, textured_draw(textures));
        const std::uint64_t texels = 16 * std::uint64_t{textures} * FillQuads;
        CHECK(figures.at("texture_texel_reads") == texels);
        CHECK(figures.at("total_cycles") > texels);
        CHECK(figures.at("total_cycles") < texels + 2000); // the first misses
    }
    const Figures figures = run(config, textured_draw(1));
    CHECK(run(config, textured_draw(1), {5}) == figures);
    CHECK(run(config, textured_draw(1), {0, Pace::EveryCycle}) == figures);
}

TexelFootprints as_nearest(const TexelFootprints& read) {
    TexelFootprints nearest;
    nearest.unit = read.unit;
    for (TexelAccess access : read.accesses()) {
        access.linear = 0;
        nearest.add(access);
    }
    return nearest;
}

TEST_CASE("texels of the border's colour take their cycles, and no line") {
    TimingConfig config = wide_machine(1);
    config.texture.rate = TexelRate::Texels;
    WorkBin bin = textured_draw(1);
    for (WorkBatch& batch : bin.tiles[0].batches)
        for (TexelFootprints& texture : batch.textures) {
            TexelFootprints beyond; // The right column of each square is.
            beyond.unit = texture.unit;
            for (TexelAccess access : texture.accesses()) {
                access.x1 = TexelAccess::BorderTexel;
                beyond.add(access);
            }
            texture = beyond;
        }
    const Figures figures = run(config, bin);
    CHECK(figures.at("texture_texel_reads") == 8 * FillQuads);
    CHECK(figures.at("total_cycles") > 16 * FillQuads);
    CHECK(figures.at("total_cycles") < 16 * FillQuads + 2000); // the first misses
    CHECK(run(config, bin, {0, Pace::EveryCycle}) == figures);
}

TEST_CASE("a sequencer takes a cycle for each texture of a quad, beside those of its samples") {
    TimingConfig config = wide_machine(1);
    config.texture.rate = TexelRate::Texels;
    for (const unsigned textures : {1u, 2u, 3u}) {
        WorkBin bin = textured_draw(textures);
        for (WorkBatch& batch : bin.tiles[0].batches)
            for (TexelFootprints& texture : batch.textures)
                texture = as_nearest(texture);
        const Figures figures = run(config, bin);
        const std::uint64_t cycles = 5 * std::uint64_t{textures} * FillQuads;
        CHECK(figures.at("total_cycles") > cycles);
        CHECK(figures.at("total_cycles") < cycles + 2000); // the first misses
    }
}

// What waits there does not hold up the rasterizer: sixteen texels a request, four a sample.
TEST_CASE("requests and samples wait in queues before the tags") {
    for (const unsigned textures : {1u, 2u}) {
        TimingConfig config = wide_machine(1);
        config.texture.rate = TexelRate::Texels;
        config.fragment.pipe_queue = 256;
        const auto stalled = [&](std::uint32_t requests, std::uint32_t samples) {
            config.texture.request_queue = requests;
            config.texture.sample_queue = samples;
            return run(config, textured_draw(textures)).at("raster_stalled_output_cycles");
        };
        const std::uint64_t few = stalled(4, 8);
        CHECK(few - stalled(6, 8) == 2 * 16);
        CHECK(few - stalled(14, 8) == 10 * 16);
        CHECK(few - stalled(4, 24) == 16 * 4);
    }
}

TEST_CASE("one quad goes round through the environments, and others wait before") {
    WorkBin bin = make_bin({8, 8, 8, [](double, double, SceneSample&) { return true; }});
    TimingConfig config = wide_machine(1);
    config.fragment.quad_cycles = 50;
    config.fragment.queue = 2;
    config.fragment.pipe_queue = 16;
    CHECK(run(config, bin).at("texture_stalled_output_cycles") == 0);
    config.fragment.entry_cycles = 1;
    // Sixteen quads; one goes round, two are in the queue. The place of one that left is free in
    // the next cycle.
    const std::uint64_t stalled = run(config, bin).at("texture_stalled_output_cycles");
    CHECK(stalled > 12 * 50);
    CHECK(stalled < 13 * 50);
}

TimingConfig without_color_cache() {
    TimingConfig config = wide_machine(1);
    config.color_cache.enable = false;
    config.color_cache.fragment_fifo = 16;
    config.color_cache.store_cycles = 5;
    config.memory.kind = MemoryKind::Fixed;
    config.memory.latency = 94;
    return config;
}

// A read takes a cycle to the memory and one back.
constexpr std::uint64_t ReadToStore = 94 + 2 + 5;

TEST_CASE("without a cache sixteen quads are between a target's read and the store") {
    const Figures figures = run(without_color_cache(), textured_draw(0));
    const double expected = FillQuads * double{ReadToStore} / 16;
    CHECK(static_cast<double>(figures.at("total_cycles")) == Approx(expected).epsilon(0.01));
    CHECK(run(without_color_cache(), textured_draw(0), {5}) == figures);
    CHECK(run(without_color_cache(), textured_draw(0), {0, Pace::EveryCycle}) == figures);
}

TEST_CASE("without a cache no two quads of one place are between read and store") {
    WorkBin bin = textured_draw(0, 0, 1);
    for (WorkBatch& batch : bin.tiles[0].batches)
        for (WorkQuad& quad : batch.quads)
            quad.x = quad.y = 0;
    const Figures figures = run(without_color_cache(), bin);
    const double expected = FillQuads * double{ReadToStore};
    CHECK(static_cast<double>(figures.at("total_cycles")) == Approx(expected).epsilon(0.01));
}

TEST_CASE("a pipe that cannot be built is refused, with what it would need") {
    TimingConfig config = wide_machine(1);
    config.depth_cache.enable = false;
    CHECK_THROWS_WITH(GpuTiming(config), Catch::Matchers::Contains("depth.test"));
    config = wide_machine(1);
    config.color_cache.enable = false;
    config.color_blocks.fast_clear = true;
    CHECK_THROWS_WITH(GpuTiming(config), Catch::Matchers::Contains("color_blocks"));
    config = wide_machine(1);
    config.raster.architecture = Architecture::TileBased;
    config.color_cache.enable = false;
    CHECK_THROWS_WITH(GpuTiming(config), Catch::Matchers::Contains("a tile's pixels"));
    config = tile_walker();
    config.raster.tile_width = 4;
    CHECK_THROWS_WITH(GpuTiming(config), Catch::Matchers::Contains("tile_width 8"));
    config = wide_machine(1);
    config.raster.architecture = Architecture::TileBased;
    config.setup.plane_cycles = 1;
    CHECK_THROWS_WITH(GpuTiming(config), Catch::Matchers::Contains("immediate machines"));
    config = wide_machine(1);
    config.texture.rate = TexelRate::Texels;
    config.texture.units = 2;
    CHECK_THROWS_WITH(GpuTiming(config), Catch::Matchers::Contains("texture.units 1"));
}

} // namespace
} // namespace ffgpu::timing
