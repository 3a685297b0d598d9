// Fast clear, compression and coarse depths on screens of one depth: what is saved is what closed
// forms say, and the order of tests is kept.

#include "tests/timing/screens.h"

#include <catch2/catch.hpp>

namespace ffgpu::timing {
namespace {

using work::DepthTest;

constexpr std::uint64_t Bytes = Size * Size * 4, Blocks = Bytes / 64;

TEST_CASE("A fast clear writes no block, and cleared blocks are not read") {
    TimingConfig config = small_caches();
    config.depth_blocks.fast_clear = config.color_blocks.fast_clear = true;
    Screens screens(config);
    screens.scene.clear(0xff203040);
    screens.screen(0.5f);
    const Figures figures = screens.end();
    CHECK(figures.at("depth_blocks_cleared") == Blocks);
    CHECK(figures.at("color_blocks_cleared") == Blocks);
    CHECK(figures.at("memory_command_written_bytes") == 0);
    CHECK(figures.at("depth_cache_read_bytes") == 0);
    CHECK(figures.at("depth_blocks_cleared_read_bytes") == Bytes);
    CHECK(figures.at("depth_cache_written_bytes") == Bytes);

    // Without, the clear writes both targets, and depth is read once.
    Screens plain(small_caches());
    plain.scene.clear(0xff203040);
    plain.screen(0.5f);
    const Figures as_before = plain.end();
    CHECK(as_before.at("memory_command_written_bytes") == 2 * Bytes);
    CHECK(as_before.at("depth_cache_read_bytes") == Bytes);
}

TEST_CASE("A clear of depth alone is fast where the stencil values are known") {
    TimingConfig config = small_caches();
    config.depth_blocks.fast_clear = true;
    Screens screens(config);
    ClearCommand depth_alone;
    depth_alone.depth = true;
    depth_alone.depth_value = 0xffffff;
    screens.scene.command(depth_alone); // The driver cleared stencil when it gave the memory.
    screens.screen(0.5f);
    screens.scene.command(depth_alone);
    CHECK(screens.end().at("depth_blocks_cleared") == 2 * Blocks);

    // Stencil values are written: from then on they are in memory.
    screens.scene.registers.stencil.enable = true;
    screens.scene.registers.stencil.front.depth_pass = StencilOp::Increment;
    screens.screen(0.25f);
    screens.scene.registers.stencil.enable = false;
    screens.scene.command(depth_alone);
    const Figures figures = screens.end();
    CHECK(figures.at("depth_blocks_cleared") == 2 * Blocks);
    CHECK(figures.at("depth_blocks_cleared_slowly") == Blocks);
}

TEST_CASE("Part of the blocks, another value: only what one register can say is fast") {
    TimingConfig config = small_caches();
    config.color_blocks.fast_clear = true;
    Screens screens(config);
    screens.scene.clear(0xff203040);
    screens.scene.registers.scissor = {0, 0, 32, 30}; // 8 x 7 whole blocks of 4 x 4, 8 in part
    ClearCommand other;
    other.color = true;
    other.color_value = 0xff000000;
    screens.scene.command(other); // Blocks outside keep the old value: slow.
    Figures figures = screens.end();
    CHECK(figures.at("color_blocks_cleared") == Blocks);
    CHECK(figures.at("color_blocks_cleared_slowly") == 8 * 8);
    CHECK(figures.at("color_blocks_resolved") == 8);
    other.color_value = 0xff203040;
    screens.scene.command(other);
    figures = screens.end();
    CHECK(figures.at("color_blocks_cleared") == Blocks + 8 * 7);
    CHECK(figures.at("color_blocks_cleared_slowly") == 8 * 8 + 8);
}

TEST_CASE("A screen of one depth and colour is written in a burst a block, and read so") {
    TimingConfig config = small_caches();
    config.depth_blocks.compression = config.color_blocks.compression = true;
    const std::uint64_t burst = config.memory.burst_cycles * config.memory.bytes_per_cycle;
    REQUIRE(burst == 16); // The codes of a plane and of one colour fit into it.
    Screens screens(config);
    screens.scene.clear(0);
    screens.screen(0.5f);
    Figures figures = screens.end();
    CHECK(figures.at("depth_cache_written_bytes") == Blocks * burst);
    CHECK(figures.at("color_cache_written_bytes") == Blocks * burst);
    CHECK(figures.at("depth_blocks_saved_write_bytes") == Blocks * (64 - burst));
    screens.screen(0.25f);
    const std::uint64_t read = figures.at("depth_cache_read_bytes");
    figures = screens.end();
    CHECK(figures.at("depth_cache_read_bytes") - read == Blocks * burst);
}

TEST_CASE("A hidden screen is culled whole once the blocks left the cache; nearer ones accepted") {
    TimingConfig config = small_caches();
    config.hierarchical_depth.keeps = CoarseDepth::MinMax;
    config.hierarchical_depth.accepts = true;
    Screens screens(config);
    screens.scene.registers.depth.compare = Compare::Lequal;
    screens.scene.clear(0);
    screens.screen(0.0f);
    Figures before = screens.end();
    screens.screen(0.5f);
    Figures figures = screens.end();
    CHECK(figures.at("hierarchical_depth_culled_quads") == Size * Size / 4);
    CHECK(figures.at("depth_cache_accesses") == before.at("depth_cache_accesses"));
    before = figures;
    screens.screen(-0.5f);
    figures = screens.end();
    CHECK(figures.at("hierarchical_depth_accepted_quads") -
              before.at("hierarchical_depth_accepted_quads") ==
          Size * Size / 4);
    CHECK(figures.at("depth_cache_read_bytes") == before.at("depth_cache_read_bytes"));
}

// Quads that are hidden gather before the test while nearer ones wait for the memory: when the last
// of these goes on, queue - 1 hidden ones stand behind it. From there on the rasterizer makes one
// in a cycle. Who tests one in a cycle stays queue - 1 behind it to the end; who tests several has
// caught up by then, and tests its last one in the cycle after it came: queue - 2 cycles sooner.
TEST_CASE("Hidden quads that had to wait are culled as many at once as are tested in a cycle") {
    const auto cycles = [](std::uint32_t tests, std::uint32_t queue) {
        TimingConfig config = small_caches();
        config.memory.refresh_interval_cycles = 0;
        config.raster.tile_cycles = config.raster.empty_tile_cycles = 0;
        config.raster.queue = queue;
        config.depth_cache.fragment_fifo = 1;
        config.hierarchical_depth.keeps = CoarseDepth::MinMax;
        config.hierarchical_depth.tests_per_cycle = tests;
        Screens screens(config);
        screens.scene.registers.depth.compare = Compare::Lequal;
        screens.scene.clear(0);
        screens.screen(0.0f);
        const std::uint64_t before = screens.end().at("total_cycles");
        screens.screen(-0.5f);
        screens.screen(0.5f);
        const Figures figures = screens.end();
        CHECK(figures.at("hierarchical_depth_culled_quads") == Size * Size / 4);
        return figures.at("total_cycles") - before;
    };
    for (const std::uint32_t queue : {32u, 64u}) {
        INFO("queue " << queue);
        CHECK(cycles(1, queue) - cycles(64, queue) == queue - 2);
        CHECK(cycles(1, queue) - cycles(2, queue) == queue - 2);
    }
}

TEST_CASE("Early where exact, a hidden screen that alpha could end is not textured; late, all is") {
    const auto texel_accesses = [](DepthTest test, bool alpha_test) {
        TimingConfig config = small_caches();
        config.depth.test = test;
        Screens screens(config);
        screens.scene.clear(0);
        screens.screen(-0.5f);
        screens.scene.texture(64, std::vector<std::uint32_t>(64 * 64, 0xffffffff));
        screens.scene.registers.fragment.alpha_test = alpha_test;
        screens.scene.registers.fragment.alpha_compare = Compare::Greater;
        screens.screen(0.5f);
        return screens.end().at("texel_cache_accesses");
    };
    CHECK(texel_accesses(DepthTest::AsGlAllows, true) > 0);
    CHECK(texel_accesses(DepthTest::EarlyWhereExact, true) == 0);
    CHECK(texel_accesses(DepthTest::AsGlAllows, false) == 0);
    CHECK(texel_accesses(DepthTest::Late, false) == texel_accesses(DepthTest::AsGlAllows, true));
}

TEST_CASE("What a fast clear overwrites is not written back any more") {
    TimingConfig config = small_caches();
    config.depth_blocks.fast_clear = true;
    Screens screens(config);
    screens.scene.clear(0);
    screens.screen(0.5f);
    screens.scene.clear(0); // The cache is full of dirty lines.
    const Figures figures = screens.end();
    const std::uint64_t held =
        config.depth_cache.sets * config.depth_cache.ways * config.depth_cache.line_bytes;
    CHECK(figures.at("depth_cache_dropped_bytes") == held * 3 / 4); // no stencil values
    CHECK(figures.at("depth_cache_written_bytes") == Bytes - held);
}

TEST_CASE("What is written of a compressed block is completed by its code") {
    TimingConfig config = small_caches();
    config.color_blocks.compression = true;
    const std::uint64_t burst = config.memory.burst_cycles * config.memory.bytes_per_cycle;
    Screens screens(config);
    screens.scene.clear(0);
    screens.screen(0.5f);
    const Figures before = screens.end();
    CHECK(before.at("memory_color_read_bytes") == 0);
    screens.scene.registers.scissor = {0, 0, Size, 2}; // half of the blocks of 4 x 4 of one row
    screens.screen(0.25f);
    const Figures figures = screens.end();
    CHECK(figures.at("color_blocks_merge_read_bytes") == Size / 4 * burst);
    CHECK(figures.at("memory_color_read_bytes") == Size / 4 * burst);
}

// --- Order -------------------------------------------------------------------------------------

// The alpha test, which all pass, makes a draw's depth test late.
void screen(Screens& screens, const Scissor& where, float z, bool late) {
    screens.scene.registers.scissor = where;
    screens.scene.registers.fragment.alpha_test = late;
    screens.scene.registers.fragment.alpha_compare = Compare::Always;
    screens.scene.registers.depth.compare = late ? Compare::Always : Compare::Less;
    screens.screen(z);
}

TimingConfig long_way_to_the_late_test() {
    TimingConfig config = small_caches();
    config.depth_cache.sets = 1;
    config.fragment.latency = 1000;
    return config;
}

TEST_CASE("An early test waits for late ones at its place that are under way") {
    TimingConfig config = long_way_to_the_late_test();
    config.depth_blocks.compression = true; // Values are followed.
    Screens screens(config);
    screens.scene.clear(0);
    screen(screens, {0, 0, 8, 8}, 0.5f, true);
    screen(screens, {0, 0, 8, 8}, 0.25f, false);
    screens.end();
    CHECK(screens.bench.differing_lines() == 0);
}

TEST_CASE("A block that leaves the cache is not narrowed below what is still to be written") {
    TimingConfig config = long_way_to_the_late_test();
    config.hierarchical_depth.keeps = CoarseDepth::MinMax;
    Screens screens(config);
    screens.scene.clear(0);
    screens.end();
    screen(screens, {0, 0, 4, 4}, -0.6f, false);   // in the cache, near
    screen(screens, {0, 0, 4, 4}, 0.8f, true);     // on its way, far
    screen(screens, {16, 0, 32, 16}, 0.0f, false); // The near line leaves the cache.
    screen(screens, {0, 0, 4, 4}, 0.0f, false);    // nearer than what is on its way
    const Figures figures = screens.end();         // What is culled is checked to fail.
    CHECK(figures.at("hierarchical_depth_culled_quads") == 0);
    CHECK(screens.bench.differing_lines() == 0);
}

} // namespace
} // namespace ffgpu::timing
