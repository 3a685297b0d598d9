// A tile-based machine's bytes against closed forms: which bins a primitive touches is told from
// coordinates, what they cost from the sizes in the configuration.

#include "tests/timing/tile_bench.h"

#include <algorithm>
#include <random>

#include <catch2/catch.hpp>

namespace ffgpu::timing {
namespace {

constexpr unsigned Width = 150, Height = 100; // of no bin a multiple

Box random_box(std::mt19937& random) {
    const auto below = [&](unsigned limit) { return static_cast<unsigned>(random() % limit); };
    const unsigned x = below(Width), y = below(Height);
    return {x,
            y,
            std::min(x + 1 + below(70), Width),
            std::min(y + 1 + below(random() % 2 ? 70 : 3), Height)};
}

struct Expected {
    std::uint64_t records = 0, entries = 0;
    BinSet bins;
};

// What all boxes of a scene are in the parameter buffer.
Expected binned(const std::vector<Box>& boxes, unsigned bin_size) {
    Expected expected;
    for (const Box& box : boxes) {
        const BinSet bins = bins_of(box, bin_size);
        ++expected.records;
        expected.entries += bins.size();
        expected.bins.insert(bins.begin(), bins.end());
    }
    return expected;
}

TEST_CASE("Parameters are written once, read once a bin, and have the bytes of the closed form") {
    std::mt19937 random(11);
    for (int round = 0; round < 40; ++round) {
        const auto from = [&](std::uint32_t least, std::uint32_t count) {
            return least + static_cast<std::uint32_t>(random() % count);
        };
        TimingConfig config = tile_based(1u << from(3, 4));
        TilesConfig& tiles = config.tiles;
        tiles.binning = from(0, 2) ? work::Binning::Exact : work::Binning::BoundingBox;
        tiles.header_bytes = from(1, 40);
        tiles.record_bytes = from(1, 200);
        tiles.entry_bytes = from(1, 12);
        tiles.gathered_entries = from(1, 16);
        tiles.entries_per_cycle = from(1, 4);
        tiles.buffers = from(1, 4);
        tiles.fetch_ahead = from(1, 6);
        tiles.parameter_buffers = from(1, 3);
        tiles.request_queue = from(1, 4);
        TileBench bench(Width, Height);
        std::vector<Box> boxes;
        for (std::uint32_t draw = from(1, 4); draw > 0; --draw) {
            std::vector<Box> more;
            for (std::uint32_t n = from(1, 6); n > 0; --n)
                more.push_back(random_box(random));
            bench.draw(more);
            boxes.insert(boxes.end(), more.begin(), more.end());
        }
        bench.end_frame();
        const Figures figures = bench.run(config);
        const Expected expected = binned(boxes, config.raster.bin_size);
        const std::uint64_t headers = expected.bins.size() * tiles.header_bytes;
        INFO("round " << round);
        CHECK(figures.at("tile_records") == expected.records);
        CHECK(figures.at("tile_entries") == expected.entries);
        CHECK(figures.at("tile_bins") == expected.bins.size());
        CHECK(figures.at("memory_parameter_written_bytes") ==
              headers + expected.records * tiles.record_bytes +
                  expected.entries * tiles.entry_bytes);
        CHECK(figures.at("memory_parameter_read_bytes") ==
              headers + expected.entries * (tiles.record_bytes + tiles.entry_bytes));
        CHECK(figures.at("memory_color_written_bytes") ==
              4 * bench.pixels(expected.bins, config.raster.bin_size));
        CHECK(figures.at("tile_overflows") == 0);
        for (const char* const unit : {"binner", "parameter_fetch", "tile_memory", "raster"})
            CHECK(figures.at(std::string(unit) + "_sum") == figures.at("total_cycles"));
    }
}

TEST_CASE(
    "A bounding box puts a primitive in bins where it covers nothing, exact binning does not") {
    TileBench bench(Width, Height);
    bench.draw({{0, 0, 2, 2}});
    auto command = std::make_shared<work::WholeCommand>(*bench.commands.back());
    command->draw.geometry.pieces[0] = {0, 0, 129, 65}; // 5 x 3 bins, by a pixel
    bench.commands.back() = command;
    bench.end_frame();
    TimingConfig config = tile_based(32);
    CHECK(bench.run(config).at("tile_entries") == 1);
    config.tiles.binning = work::Binning::BoundingBox;
    const Figures figures = bench.run(config);
    CHECK(figures.at("tile_entries") == 5 * 3);
    CHECK(figures.at("memory_color_written_bytes") == 4 * 32 * 32); // where something is new
}

TEST_CASE("With bounding boxes the empty blocks of every bin are walked, and cost their cycles") {
    constexpr unsigned Size = 256, Bin = 32, Block = 8; // 64 bins of 16 blocks
    TileBench bench(Size, Size);
    bench.draw({{0, 0, 2, 2}});
    auto command = std::make_shared<work::WholeCommand>(*bench.commands.back());
    command->draw.geometry.pieces[0] = {0, 0, Size, Size};
    bench.commands.back() = command;
    bench.end_frame();
    const auto run = [&](work::Binning binning, std::uint32_t empty_cycles) {
        TimingConfig config = tile_based(Bin);
        config.raster.tile_width = Block;
        config.raster.empty_tile_cycles = empty_cycles;
        config.tiles.binning = binning;
        return bench.run(config);
    };
    constexpr std::uint64_t InBin = Bin / Block * Bin / Block, InBox = Size / Block * Size / Block;
    const Figures exact = run(work::Binning::Exact, 1);
    CHECK(exact.at("raster_blocks") + exact.at("raster_empty_blocks") == InBin);
    const Figures boxed = run(work::Binning::BoundingBox, 1);
    CHECK(boxed.at("raster_blocks") == 1);
    CHECK(boxed.at("raster_empty_blocks") == InBox - 1);
    // Far slower than all else, the walk is the frame: a cycle more a block costs one each.
    const Figures slow = run(work::Binning::BoundingBox, 60);
    const Figures slower = run(work::Binning::BoundingBox, 61);
    CHECK(slower.at("total_cycles") - slow.at("total_cycles") == InBox - 1);
    CHECK(slower.at("raster_busy_cycles") - slow.at("raster_busy_cycles") == InBox - 1);
}

TEST_CASE("Cleared depth that nobody reads later costs no traffic; colour is stored once a bin") {
    TileBench bench(Width, Height);
    bench.state.depth = {.test_enable = true, .write_enable = true};
    for (int frame = 0; frame < 3; ++frame) {
        bench.clear(true, true);
        bench.draw({{0, 0, 120, 90}});
        bench.draw({{10, 10, Width, 60}, {3, 3, 5, 5}});
        bench.end_frame();
    }
    const Figures figures = bench.run(tile_based());
    CHECK(figures.at("memory_depth_read_bytes") == 0);
    CHECK(figures.at("memory_depth_written_bytes") == 0);
    CHECK(figures.at("memory_color_read_bytes") == 0);
    CHECK(figures.at("memory_command_written_bytes") == 0);
    CHECK(figures.at("memory_color_written_bytes") == 3 * 4 * Width * Height);
    CHECK(figures.at("tile_needless_stores") == 2 * 5 * 4); // of the first two frames' bins
}

TEST_CASE("Depth that the next frame tests against is stored once and loaded once") {
    TileBench bench(Width, Height);
    bench.state.depth = {.test_enable = true, .write_enable = true};
    bench.clear(true, true, true);
    bench.draw({bench.all()});
    bench.end_frame();
    const Box later{20, 30, 70, 34};
    bench.draw({later});
    bench.end_frame();
    bench.end_frame();
    const std::uint64_t loaded = 4 * bench.pixels(bins_of(later, 32), 32);
    const Figures figures = bench.run(tile_based());
    CHECK(figures.at("memory_depth_read_bytes") == loaded);
    CHECK(figures.at("tile_depth_loaded_bytes") == loaded);
    // The bins that the second frame left alone wait until the third is over.
    CHECK(figures.at("memory_depth_written_bytes") == 4 * Width * Height);
    CHECK(figures.at("memory_color_read_bytes") == loaded); // Bins of which some pixels stay.
}

TEST_CASE("A clear of some channels alone loads the bins that it is stored to") {
    for (const Box& cleared : {Box{0, 0, Width, Height}, Box{0, 0, 50, 40}}) {
        TileBench bench(Width, Height);
        bench.draw({bench.all()});
        bench.end_frame();
        bench.state.blend.write_mask = 0b0101;
        bench.state.scissor = {.x = 0,
                               .y = 0,
                               .width = static_cast<std::uint16_t>(cleared.x1),
                               .height = static_cast<std::uint16_t>(cleared.y1)};
        bench.clear(true, false);
        bench.end_frame();
        const std::uint64_t touched = 4 * bench.pixels(bins_of(cleared, 32), 32);
        const Figures figures = bench.run(tile_based());
        CHECK(figures.at("tile_color_loaded_bytes") == touched);
        CHECK(figures.at("tile_color_stored_bytes") == 4 * Width * Height + touched);
    }
}

TEST_CASE("A clear on chip takes the bin's pixels, a primitive in a bin its cycles") {
    constexpr std::uint32_t Primitives = 10;
    TileBench bench(32, 32);
    bench.clear(true, true);
    bench.draw(std::vector<Box>(Primitives, bench.all()));
    bench.end_frame();
    const auto cycles = [&](std::uint32_t pixels_per_cycle, std::uint32_t entry_cycles) {
        TimingConfig config = tile_based(32);
        config.memory.profile = MemoryProfile::Ideal;
        config.memory.apply_profile();
        config.tiles.clear_pixels_per_cycle = pixels_per_cycle;
        config.tiles.entry_cycles = entry_cycles;
        return bench.run(config).at("total_cycles");
    };
    CHECK(cycles(1, 1) - cycles(64, 1) == 32 * 32 - 32 * 32 / 64);
    CHECK(cycles(64, 40) - cycles(64, 1) == (40 - 1) * Primitives);
}

TEST_CASE("A bin's lines are loaded and stored lines_per_cycle at a time") {
    TileBench bench(32, 32);
    Box lower = bench.all();
    lower.y1 = 16; // The other pixels stay as they are: the bin is loaded.
    bench.draw({lower});
    bench.end_frame();
    const auto figures = [&](std::uint32_t lines) {
        TimingConfig config = tile_based(32);
        config.memory.kind = MemoryKind::Fixed;
        config.memory.channels = 16;
        config.memory.interleave_bytes = 64;
        config.tiles.lines_per_cycle = lines;
        return bench.run(config);
    };
    const Figures one = figures(1);
    std::uint64_t lines = 0;
    for (const char* const moved : {"tile_color_loaded_bytes",
                                    "tile_depth_loaded_bytes",
                                    "tile_color_stored_bytes",
                                    "tile_depth_stored_bytes"})
        lines += one.at(moved) / 64;
    CHECK(lines == 2 * 32 * 32 * 4 / 64); // Colour comes and goes.
    for (const std::uint32_t wide : {2u, 4u, 8u})
        CHECK(one.at("total_cycles") - figures(wide).at("total_cycles") == lines - lines / wide);
}

TEST_CASE("Entries of a list are written together") {
    TileBench bench(32, 32);
    bench.draw(std::vector<Box>(16, bench.all()));
    bench.end_frame();
    TimingConfig config = tile_based(32);
    config.tiles.header_bytes = 64; // Lists begin with a request.
    const auto requests = [&](std::uint32_t gathered) {
        config.tiles.gathered_entries = gathered;
        return bench.run(config).at("memory_parameter_requests");
    };
    CHECK(requests(1) - requests(8) == 16 - 2);
}

TEST_CASE("A clear ends where the smallest of its targets does") {
    TileBench bench(Width, Height);
    bench.state.targets.depth.width = 64; // two bins
    bench.clear(true, false);
    bench.end_frame();
    const Figures figures = bench.run(tile_based(32));
    CHECK(figures.at("memory_color_written_bytes") == 4 * 64 * Height);
    CHECK(figures.at("memory_color_read_bytes") == 0);
}

TEST_CASE("On the host's bus are the commands that the host gave, and no stores of the machine's") {
    TileBench bench(Width, Height, 4);
    bench.state.depth = {.test_enable = true, .write_enable = true};
    bench.clear(true, true, true);
    bench.draw({bench.all()});
    bench.resolve();
    bench.end_frame();
    bench.draw({{20, 30, 70, 34}}); // Needs bins of both that were not stored.
    bench.end_frame();
    constexpr std::uint64_t Commands = 4, Frames = 2;
    const TimingConfig config = tile_based();
    const std::uint64_t command = config.host.command_bytes +
                                  TileBench::RegisterWrites * config.host.register_bytes +
                                  TileBench::RegisterWords * 4;
    const Figures figures = bench.run(config);
    CHECK(figures.at("memory_depth_written_bytes") > figures.at("tile_depth_stored_bytes"));
    CHECK(figures.at("host_command_bytes") ==
          Commands * command + Frames * config.host.command_bytes);
}

TEST_CASE("A clear of depth alone keeps stencil on its way, and only as long as one is there") {
    TileBench bench(64, 64);
    bench.state.stencil.enable = true;
    bench.clear(true, false, true);
    bench.draw({bench.all()}); // Stencil is new in every bin.
    bench.end_frame();
    bench.state.stencil.enable = false;
    bench.state.depth = {.test_enable = true, .write_enable = true};
    bench.clear(true, true);
    bench.draw({bench.all()});
    bench.end_frame();
    bench.clear(true, true, true); // Now nobody can ask for either any more.
    bench.end_frame();
    const Figures figures = bench.run(tile_based());
    CHECK(figures.at("memory_depth_read_bytes") == 0);
    CHECK(figures.at("memory_depth_written_bytes") == 0);
    CHECK(figures.at("tile_needless_stores") == 4); // The clear of depth alone took none.
}

TEST_CASE("Colour is loaded where it is blended or kept, not where it is overwritten") {
    const auto loaded = [](bool detects, bool blend, const std::vector<Box>& boxes) {
        TileBench bench(64, 64);
        bench.state.blend.enable = blend;
        bench.state.blend.rgb_destination = BlendFactor::SourceAlpha;
        bench.draw(boxes);
        bench.end_frame();
        TimingConfig config = tile_based(32);
        config.tiles.detects_overwrite = detects;
        return bench.run(config).at("memory_color_read_bytes");
    };
    constexpr std::uint64_t Bin = 32 * 32 * 4;
    const std::vector<Box> halves{{0, 0, 32, 17}, {0, 17, 32, 32}};
    CHECK(loaded(true, false, halves) == 0);
    CHECK(loaded(true, false, {{0, 0, 32, 31}}) == Bin); // a row stays
    CHECK(loaded(true, false, {{0, 0, 33, 32}}) == Bin); // of the second bin most stays
    CHECK(loaded(true, true, halves) == Bin);            // what was there is read
    CHECK(loaded(false, false, halves) == Bin);          // nobody knows
    CHECK(loaded(true, false, {{0, 0, 64, 64}}) == 0);
}

TEST_CASE("Clears in the middle of a scene are done on chip") {
    TileBench bench(Width, Height);
    bench.state.depth = {.test_enable = true, .write_enable = true};
    bench.clear(true, true);
    bench.draw({{0, 0, 64, 64}});
    bench.clear(false, true); // a record, with an entry a bin
    bench.draw({{0, 0, 64, 64}});
    bench.state.scissor = {.x = 0, .y = 0, .width = 40, .height = 8};
    bench.clear(true, false); // of a part: two bins
    bench.end_frame();
    const TimingConfig config = tile_based();
    const Figures figures = bench.run(config);
    CHECK(figures.at("tile_scenes") == 1);
    CHECK(figures.at("tile_records") == 2 + 2);
    CHECK(figures.at("tile_entries") == 2 * 4 + 5 * 4 + 2);
    CHECK(figures.at("tile_clears") == 5 * 4 + 5 * 4 + 2);
    CHECK(figures.at("memory_color_written_bytes") == 4 * Width * Height);
    CHECK(figures.at("memory_color_read_bytes") == 0);
    CHECK(figures.at("memory_depth_read_bytes") + figures.at("memory_depth_written_bytes") == 0);
    CHECK(figures.at("memory_command_written_bytes") == 0);
}

TEST_CASE("Samples are resolved on chip, and only pixels are stored") {
    TileBench bench(Width, Height, MaxSamples);
    bench.state.multisample.enable = true;
    for (int frame = 0; frame < 2; ++frame) {
        bench.clear(true, true);
        bench.draw({{0, 0, 50, 50}});
        bench.resolve();
        bench.end_frame();
    }
    const Figures figures = bench.run(tile_based());
    CHECK(figures.at("memory_color_written_bytes") == 2 * 4 * Width * Height);
    CHECK(figures.at("memory_color_read_bytes") == 0);
    CHECK(figures.at("memory_command_read_bytes") == 0);
    CHECK(figures.at("memory_command_written_bytes") == 0);
}

TEST_CASE(
    "Of a window's two buffers of samples, each cleared in its next frame, pixels are stored") {
    constexpr int Frames = 5;
    TileBench bench(Width, Height, MaxSamples);
    bench.state.multisample.enable = true;
    for (int frame = 0; frame < Frames; ++frame) {
        bench.state.targets.color[0].address =
            TileBench::ColorAt + (frame % 2) * (TileBench::ColorAt / 2);
        bench.clear(true, true);
        bench.draw({{0, 0, 50, 50}});
        bench.resolve();
        bench.end_frame();
    }
    const Figures figures = bench.run(tile_based());
    CHECK(figures.at("memory_color_written_bytes") == Frames * 4 * Width * Height);
    CHECK(figures.at("memory_color_read_bytes") == 0);
}

TEST_CASE("Samples that nobody clears for two frames are stored once") {
    TileBench bench(Width, Height, MaxSamples);
    bench.state.multisample.enable = true;
    bench.clear(true, true);
    bench.draw({{0, 0, 50, 50}});
    bench.resolve();
    bench.state.targets.color[0].address = TileBench::ColorAt + TileBench::ColorAt / 2;
    for (int frame = 0; frame < 3; ++frame) {
        bench.end_frame();
        bench.clear(true, false);
    }
    const Figures figures = bench.run(tile_based());
    constexpr std::uint64_t Pixels = Width * Height;
    CHECK(figures.at("memory_color_written_bytes") == 4 * Pixels + 16 * Pixels + 2 * 16 * Pixels);
}

TEST_CASE("A resolve of bins that the scene did not touch loads their samples") {
    TileBench bench(Width, Height, MaxSamples);
    bench.draw({{0, 0, 32, 32}});
    bench.resolve();
    bench.end_frame();
    const Figures figures = bench.run(tile_based());
    CHECK(figures.at("memory_color_read_bytes") == 16 * (Width * Height - 32 * 32));
    CHECK(figures.at("memory_color_written_bytes") == 4 * Width * Height);
}

} // namespace
} // namespace ffgpu::timing
