// A tile-based machine with little room: full parameter buffers, one place in every queue, and any
// order of evaluation.

#include "tests/timing/tile_bench.h"

#include <algorithm>
#include <random>

#include <catch2/catch.hpp>

namespace ffgpu::timing {
namespace {

constexpr unsigned Width = 96, Height = 96, Bin = 32;

std::vector<Box> boxes(unsigned count, std::uint32_t seed) {
    std::mt19937 random(seed);
    std::vector<Box> list;
    for (unsigned i = 0; i < count; ++i) {
        const auto x = static_cast<unsigned>(random() % 90),
                   y = static_cast<unsigned>(random() % 90);
        list.push_back({x,
                        y,
                        std::min(Width, x + 1 + static_cast<unsigned>(random() % 40)),
                        std::min(Height, y + 1 + static_cast<unsigned>(random() % 40))});
    }
    return list;
}

struct Pass {
    std::vector<Box> boxes;
    BinSet bins;
};

// Fills a buffer with one primitive after the other and begins anew where the next does not fit.
// The first pass has the bins of a clear from its beginning.
std::vector<Pass> passes_of(const std::vector<Box>& list, const TilesConfig& tiles) {
    std::vector<Pass> passes{{{}, bins_of({0, 0, Width, Height}, Bin)}};
    std::uint64_t bytes = passes[0].bins.size() * tiles.header_bytes;
    for (const Box& box : list) {
        const BinSet of_box = bins_of(box, Bin);
        const auto more = [&] {
            BinSet all = passes.back().bins;
            all.insert(of_box.begin(), of_box.end());
            return (all.size() - passes.back().bins.size()) * tiles.header_bytes +
                   tiles.record_bytes + of_box.size() * tiles.entry_bytes;
        };
        if (!passes.back().boxes.empty() && bytes + more() > tiles.parameter_buffer_bytes) {
            passes.emplace_back();
            bytes = 0;
        }
        bytes += more();
        passes.back().boxes.push_back(box);
        passes.back().bins.insert(of_box.begin(), of_box.end());
    }
    return passes;
}

TEST_CASE("A scene that does not fit is drawn in parts, each with its loads and stores") {
    TimingConfig config = tile_based(Bin);
    config.tiles.parameter_buffer_bytes = GENERATE(64u, 500u, 2000u, 1u << 20);
    const std::vector<Box> list = boxes(60, 5);
    TileBench bench(Width, Height);
    bench.state.depth = {.test_enable = true, .write_enable = true};
    bench.state.blend.enable = true;
    bench.clear(true, true, true);
    bench.draw(list);
    bench.end_frame();
    bench.clear(true, true, true); // Whatever depth is left is of no use.
    bench.end_frame();
    const Figures figures = bench.run(config);

    const std::vector<Pass> passes = passes_of(list, config.tiles);
    constexpr std::uint64_t Whole = 4 * Width * Height, AllBins = 9;
    std::uint64_t loaded = 0, stored = 0, last = 0, bins = 0;
    for (const Pass& pass : passes) {
        last = 4 * bench.pixels(pass.bins, Bin);
        if (&pass != &passes[0]) loaded += last;
        stored += last;
        bins += pass.bins.size();
    }
    INFO("buffer " << config.tiles.parameter_buffer_bytes);
    CHECK(figures.at("tile_overflows") == passes.size() - 1);
    CHECK(figures.at("tile_bins") == bins + AllBins);
    CHECK(figures.at("memory_color_read_bytes") == loaded);
    CHECK(figures.at("memory_color_written_bytes") == stored + Whole);
    CHECK(figures.at("memory_depth_read_bytes") == loaded);
    CHECK(figures.at("memory_depth_written_bytes") == stored - last); // All but the last pass.
}

TEST_CASE("A tile-based machine with one place in every queue ends") {
    TileBench bench(Width, Height);
    bench.state.depth = {.test_enable = true, .write_enable = true};
    bench.clear(true, true);
    bench.draw(boxes(20, 3));
    bench.end_frame();
    TimingConfig config = tile_based(8);
    config.vertex.fetch_queue = config.setup.queue = config.raster.queue = 1;
    config.fragment.queue = config.fragment.pipe_queue = 1;
    config.memory.queue = 1;
    config.memory.client_queue = 2;
    config.tiles.request_queue = config.tiles.buffers = config.tiles.fetch_ahead = 1;
    config.tiles.parameter_buffers = 1;
    config.tiles.parameter_buffer_bytes = 300;
    const Figures tight = bench.run(config), wide = bench.run(tile_based(8));
    CHECK(tight.at("total_cycles") > wide.at("total_cycles"));
    CHECK(tight.at("tile_entries") == wide.at("tile_entries"));
}

// The draws of a scene leave the pipe together: none of them can wait for the one before.
TEST_CASE("A tile-based machine that drains begins a scene when the one before is stored") {
    const auto cycles = [](bool drains, const std::vector<DeviceAddress>& targets) {
        TileBench bench(Width, Height);
        for (const DeviceAddress target : targets) {
            bench.state.targets.color[0].address = target;
            bench.draw(boxes(10, 1));
            bench.draw(boxes(10, 2));
        }
        bench.end_frame();
        TimingConfig config = tile_based(Bin);
        config.memory.kind = MemoryKind::Fixed; // Nobody gains by waiting.
        config.vertex.transform_cycles = 100;   // A scene's vertices take as long as its bins.
        config.command_processor.drains = drains;
        return bench.run(config).at("total_cycles");
    };
    constexpr DeviceAddress A = TileBench::ColorAt, B = TileBench::ResolvedAt;
    const std::uint64_t one = cycles(false, {A}), other = cycles(false, {B});
    CHECK(cycles(true, {A}) == one); // A scene alone waits for nothing.
    const std::uint64_t together = cycles(false, {A, B}), apart = cycles(true, {A, B});
    CHECK(apart > together + 1000);
    // One after the other, but for the host's way to the first draw and the end of the frame.
    CHECK(apart <= one + other);
    CHECK(apart + 200 > one + other);
}

TEST_CASE("The order in which a tile-based machine's units are evaluated changes no figure") {
    TileBench bench(Width, Height);
    bench.state.depth = {.test_enable = true, .write_enable = true};
    bench.clear(true, true);
    bench.draw(boxes(30, 1));
    bench.clear(false, true);
    bench.draw(boxes(30, 2));
    bench.end_frame();
    bench.draw(boxes(9, 4));
    bench.end_frame();
    TimingConfig config = tile_based(16);
    config.raster.quads_per_cycle = 2;
    config.tiles.parameter_buffer_bytes = 2500;
    const Figures plain = bench.run(config);
    REQUIRE(plain.at("tile_overflows") > 1);
    for (std::uint32_t seed = 1; seed <= 8; ++seed) {
        INFO("seed " << seed);
        CHECK(bench.run(config, seed) == plain);
    }
    CHECK(bench.run(config, {0, Pace::EveryCycle}) == plain);
}

} // namespace
} // namespace ffgpu::timing
