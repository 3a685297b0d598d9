// The machine in time on analytic scenes: cache figures of the literature, accounts that add up,
// determinism.

#include "tests/timing/analytic_scenes.h"
#include "tests/timing/machine_figures.h"

#include <cmath>
#include <string>

#include <catch2/catch.hpp>

namespace ffgpu::timing {
namespace {

Figures run(const TimingConfig& config, const Scene& scene, const Evaluation& evaluation = {}) {
    return run(config, make_bin(scene), evaluation);
}

double miss_percent(const Figures& figures) {
    return 100.0 * static_cast<double>(figures.at("texel_cache_misses")) /
           static_cast<double>(figures.at("texture_texel_reads"));
}

TEST_CASE("a one-to-one bilinear picture misses once per line: 1.5625 percent of its reads") {
    TimingConfig config;
    config.texel_cache.sets = 256; // 64 KB
    const Figures figures = run(config, planar_scene(512));
    CHECK(miss_percent(figures) == Approx(1.5625).epsilon(0.02));
    // Every line once; the rest are the repeated texture's far edges, met again.
    CHECK(figures.at("texel_cache_compulsory_misses") == 512 * 512 / 16);
}

TEST_CASE("a trilinear picture at level f reads 1.25 * 4^f unique texels a fragment") {
    for (const auto& [level, percent] : {std::pair{0.001, 1.001}, {0.5, 1.966}, {0.999, 3.906}}) {
        TimingConfig config;
        config.texel_cache.sets = 1024;
        config.texel_cache.ways = 16; // 1 MB
        INFO("level " << level);
        CHECK(miss_percent(run(config, uniform_level_scene(512, level))) ==
              Approx(percent).epsilon(0.02));
    }
}

TEST_CASE(
    "the texels that a trilinear picture reads first are 1.25 * 4^f a fragment, in quads or not") {
    constexpr unsigned TexelsOfLine = 4;
    // The picture's edges, where half a line's texels are read, are a smaller part of a large one.
    for (const auto& [level, size] : {std::pair{0.001, 1024u}, {0.5, 512u}, {0.999, 512u}}) {
        for (const work::Granularity granularity :
             {work::Granularity::Quad, work::Granularity::Fragment}) {
            TimingConfig config;
            config.raster.granularity = granularity;
            config.texel_cache.line_bytes = 4 * TexelsOfLine;
            config.texel_cache.block_width = 2;
            config.texel_cache.sets = 4096;
            config.texel_cache.ways = 16; // 1 MB
            INFO("level " << level << ", granularity " << static_cast<int>(granularity));
            const Figures figures = run(config, uniform_level_scene(size, level));
            const double first_reads =
                TexelsOfLine * static_cast<double>(figures.at("texel_cache_compulsory_misses"));
            CHECK(first_reads / (size * size) == Approx(1.25 * std::pow(4, level)).epsilon(0.01));
        }
    }
}

TEST_CASE("the perspective floor has the published miss rates") {
    const auto floor_with =
        [](Layout layout, Traversal traversal, unsigned tile, std::uint32_t kilobytes) {
            TimingConfig config;
            config.texel_cache.layout = layout;
            config.raster.traversal = traversal;
            config.raster.tile_width = tile;
            config.texel_cache.sets = 1;
            config.texel_cache.ways = kilobytes * 1024 / 64;
            return miss_percent(run(config, floor_scene(256)));
        };
    // Quads instead of single fragments visit the picture in pairs of rows: within 15 percent.
    CHECK(floor_with(Layout::Blocked, Traversal::Tiled, 8, 16) == Approx(0.85).epsilon(0.15));
    CHECK(floor_with(Layout::Linear, Traversal::Column, 8, 16) == Approx(17.34 / 2).epsilon(0.15));
}

TEST_CASE("every unit accounts for every cycle, every cache for every access") {
    const auto samples = GENERATE(std::uint8_t{1}, std::uint8_t{MaxSamples});
    const Figures figures = run(TimingConfig{}, make_bin(floor_scene(1024), samples));
    for (const auto& [name, value] : figures) {
        if (name.ends_with("_sum")) {
            INFO(name);
            CHECK(value == figures.at("total_cycles"));
        }
    }
    for (const std::string cache : {"vertex_cache", "texel_cache", "depth_cache", "color_cache"}) {
        INFO(cache);
        const std::uint64_t misses = figures.at(cache + "_misses");
        CHECK(figures.at(cache + "_hits") + misses == figures.at(cache + "_accesses"));
        CHECK(figures.at(cache + "_compulsory_misses") + figures.at(cache + "_capacity_misses") +
                  figures.at(cache + "_conflict_misses") ==
              misses);
        CHECK(figures.at(cache + "_read_bytes") ==
              64 * (misses - figures.at(cache + "_misses_without_fetch")));
    }
    CHECK(figures.at("memory_color_written_bytes") == figures.at("color_cache_written_bytes"));
    CHECK(figures.at("memory_texture_read_bytes") == figures.at("texel_cache_read_bytes"));
}

TEST_CASE("the order in which the units are evaluated changes no figure") {
    TimingConfig narrow; // Full queues and refused requests everywhere.
    narrow.texel_cache.fragment_fifo = 3;
    narrow.texel_cache.outstanding_lines = 2;
    narrow.fragment.queue = 2;
    narrow.raster.quads_per_cycle = 2;
    narrow.memory.queue = 2;
    for (const TimingConfig& config : {TimingConfig{}, narrow}) {
        const Figures in_pipe_order = run(config, floor_scene(256));
        for (const std::uint32_t seed : {1u, 2u, 3u, 4u, 5u})
            CHECK(run(config, floor_scene(256), seed) == in_pipe_order);
        const WorkBin sampled = make_bin(floor_scene(256), MaxSamples);
        CHECK(run(config, sampled, 1) == run(config, sampled, 2));
    }
}

TEST_CASE("a second machine in the same process takes the same cycles") {
    const Figures once = run(TimingConfig{}, floor_scene(256));
    CHECK(run(TimingConfig{}, floor_scene(256)) == once);
}

TEST_CASE("a deep fragment FIFO hides the memory's latency") {
    const auto cycles = [](std::uint32_t fifo) {
        TimingConfig config;
        config.texel_cache.fragment_fifo = fifo;
        config.memory.latency = 200;
        return run(config, floor_scene(1024)).at("total_cycles");
    };
    const auto shallow = cycles(4), deep = cycles(256);
    CHECK(shallow > 2 * deep);
}

TEST_CASE("the samples of a quad lie in two lines, and all their bytes are carried") {
    constexpr unsigned Size = 128;
    const Figures one = run(TimingConfig{}, make_bin(planar_scene(Size)));
    const Figures four = run(TimingConfig{}, make_bin(planar_scene(Size), MaxSamples));
    CHECK(one.at("color_cache_accesses") == Size * Size / 4);
    // A row of four pixels is a line: 64 bytes.
    CHECK(four.at("color_cache_accesses") == 2 * Size * Size / 4);
    CHECK(four.at("color_cache_written_bytes") == Size * Size * 16);
    CHECK(four.at("depth_cache_accesses") == 2 * Size * Size / 4);
    CHECK(four.at("depth_cache_read_bytes") == Size * Size * 16);
    CHECK(four.at("depth_cache_written_bytes") == Size * Size * 16);
}

TEST_CASE("a resolve reads every sample and writes every pixel once") {
    constexpr std::uint16_t Size = 64;
    WorkBin bin;
    WorkDraw& copy = bin.draws.emplace_back();
    copy.kind = WorkKind::Copy;
    copy.copy.destination = {.address = 1 << 26,
                             .format = Format::Rgba8,
                             .width = Size,
                             .height = Size,
                             .stride = Size * 4};
    copy.copy.source = copy.copy.destination;
    copy.copy.source.address = 1 << 27;
    copy.copy.source.samples = MaxSamples;
    copy.copy.width = copy.copy.height = Size;
    const Figures figures = run(TimingConfig{}, bin);
    CHECK(figures.at("memory_command_read_bytes") == Size * Size * 16);
    CHECK(figures.at("memory_command_written_bytes") == Size * Size * 4);
}

TEST_CASE("a tile-based machine does the same work") {
    TimingConfig tiled;
    tiled.raster.architecture = Architecture::TileBased;
    const Figures a = run(TimingConfig{}, floor_scene(256)), b = run(tiled, floor_scene(256));
    CHECK(a.at("texture_texel_reads") == b.at("texture_texel_reads"));
    CHECK(a.at("texture_quads") == b.at("texture_quads"));
}

} // namespace
} // namespace ffgpu::timing
