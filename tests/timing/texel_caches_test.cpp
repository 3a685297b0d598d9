// Texel caches of each pipe's own, the second level behind them, optimal replacement, and
// compressed textures, through the whole machine: against closed forms and against a simulation
// that shares no code with it.

#include "tests/timing/picture_quads.h"

#include <algorithm>
#include <list>
#include <map>
#include <numeric>

#include <catch2/catch.hpp>

namespace ffgpu::timing {
namespace {

// A fully associative cache with LRU replacement.
class PlainCache {
public:
    explicit PlainCache(std::size_t lines)
        : lines_(lines) {}
    bool misses(unsigned line) {
        const auto found = std::find(held_.begin(), held_.end(), line);
        const bool missed = found == held_.end();
        if (!missed) held_.erase(found);
        held_.push_front(line);
        if (held_.size() > lines_) held_.pop_back();
        return missed;
    }

private:
    std::size_t lines_;
    std::list<unsigned> held_;
};

std::string own(std::uint32_t pipe) {
    return "texel_cache_" + std::to_string(pipe);
}

TEST_CASE("Each pipe's cache misses as a plain cache does that sees the pipe's quads") {
    constexpr std::uint32_t Lines = 16;
    const std::vector<QuadLines> quads = quads_in_order();
    for (const Distribution distribution : {Distribution::Tiles, Distribution::Scanlines}) {
        for (const std::uint32_t pipes : {2u, 4u, 16u}) {
            TimingConfig config = caches_machine(pipes, distribution, 4);
            config.texel_cache.ways = Lines;
            const Figures figures = run(config, picture());
            std::vector<PlainCache> plain(pipes, PlainCache(Lines));
            std::vector<std::uint64_t> misses(pipes, 0);
            for (const QuadLines& quad : quads) {
                const unsigned pipe = pipe_of(quad, distribution, 4, pipes);
                for (const unsigned line : quad.lines)
                    misses[pipe] += plain[pipe].misses(line);
            }
            INFO(pipes << " pipes");
            for (std::uint32_t pipe = 0; pipe < pipes; ++pipe)
                CHECK(figures.at(own(pipe) + "_misses") == misses[pipe]);
            CHECK(figures.at("texel_cache_misses") ==
                  std::accumulate(misses.begin(), misses.end(), std::uint64_t{0}));
            CHECK(figures.at("memory_texture_read_bytes") == 64 * figures.at("texel_cache_misses"));
        }
    }
}

TEST_CASE("A second level that holds the texture reads each of its lines once for all pipes") {
    constexpr std::uint64_t Unique = PictureSize * PictureSize / 16;
    for (const std::uint32_t line_bytes : {64u, 256u}) {
        TimingConfig config = caches_machine(4, Distribution::Scanlines, 2);
        config.texel_cache.ways = 16;
        config.texel_l2.enable = true;
        config.texel_l2.sets = 1024;
        config.texel_l2.line_bytes = line_bytes;
        config.memory.interleave_bytes = 256;
        const Figures figures = run(config, picture());
        CHECK(figures.at("texel_l2_accesses") == figures.at("texel_cache_misses"));
        CHECK(figures.at("texel_l2_misses") == Unique * 64 / line_bytes);
        CHECK(figures.at("memory_texture_read_bytes") == Unique * 64);
        CHECK(figures.at("texel_cache_misses") > Unique);
        for (const std::string unit : {"texture", "texel_l2", "arbiter"})
            CHECK(figures.at(unit + "_sum") == figures.at("total_cycles"));
    }
}

TEST_CASE("1 to 16 pipes share a textured draw with caches and texture units of their own") {
    for (const std::uint32_t pipes : {1u, 2u, 4u, 8u, 16u}) {
        TimingConfig config = wide_machine(pipes);
        config.texel_cache.per_pipe = true;
        config.texel_cache.ports = 8; // of each cache: four lines for each unit
        config.texture.units = 2;
        config.texel_l2.enable = true;
        config.texel_l2.lookups_per_cycle = pipes; // Each fills its cache at the beginning.
        const std::uint64_t share = FillQuads / pipes;
        const std::uint64_t cycles = run(config, textured_draw(2)).at("total_cycles");
        INFO(pipes << " pipes");
        CHECK(cycles >= share);
        CHECK(static_cast<double>(cycles - fill_and_drain(config) - config.texel_l2.latency) <=
              1.05 * static_cast<double>(share));
    }
}

TEST_CASE("A port is each cache's own: one look-up a cycle of every pipe, or of all together") {
    // Quads of four lines each: every other texel row and column begins a block.
    const auto cycles = [](bool per_pipe) {
        TimingConfig config = wide_machine(4);
        config.texel_cache.per_pipe = per_pipe;
        config.texel_cache.ports = 1;
        const Figures figures = run(config, textured_draw(1));
        return std::pair(figures.at("total_cycles"), figures.at("texel_cache_accesses"));
    };
    const auto [shared, lookups] = cycles(false);
    CHECK(shared >= lookups);
    CHECK(static_cast<double>(shared) <= 1.05 * static_cast<double>(lookups));
    CHECK(static_cast<double>(cycles(true).first) <= 1.05 * static_cast<double>(lookups) / 4 + 100);
}

TEST_CASE("A second level's link carries as many lines a cycle as its bytes hold") {
    // A cache of one line: nearly every look-up is a miss, which the second level answers.
    const auto cycles = [](std::uint32_t bytes_per_cycle) {
        TimingConfig config = wide_machine(4);
        config.texel_cache.sets = config.texel_cache.ways = 1;
        config.texel_cache.miss_queue = config.texel_cache.lookups_per_cycle = 16;
        config.texel_cache.request_queue = config.texel_cache.outstanding_lines = 4096;
        config.texel_l2.enable = true;
        config.texel_l2.sets = 1024;
        config.texel_l2.lookups_per_cycle = 64;
        config.texel_l2.queue = 4096;
        config.texel_l2.bytes_per_cycle = bytes_per_cycle;
        const Figures figures = run(config, textured_draw(1));
        return std::pair(figures.at("total_cycles"), figures.at("texel_cache_misses"));
    };
    for (const std::uint32_t lines : {1u, 2u, 4u}) {
        const auto [taken, misses] = cycles(64 * lines);
        INFO(lines << " lines a cycle");
        CHECK(taken >= misses / lines);
        CHECK(static_cast<double>(taken) <= 1.05 * static_cast<double>(misses) / lines + 300);
    }
}

TEST_CASE("Optimal replacement in the machine never misses more than another policy") {
    WorkBin bin = make_bin(floor_scene(256));
    for (const bool per_pipe : {false, true}) {
        std::map<work::Replacement, Figures> figures;
        for (const work::Replacement replacement : {work::Replacement::Lru,
                                                    work::Replacement::Fifo,
                                                    work::Replacement::Random,
                                                    work::Replacement::Optimal}) {
            TimingConfig config;
            config.raster.quads_per_cycle = per_pipe ? 4 : 1;
            config.texel_cache.per_pipe = per_pipe;
            config.texel_cache.sets = 4;
            config.texel_cache.replacement = replacement;
            figures[replacement] = run(config, bin);
        }
        const Figures& best = figures[work::Replacement::Optimal];
        for (const auto& [replacement, other] : figures) {
            CHECK(other.at("texel_cache_accesses") == best.at("texel_cache_accesses"));
            for (std::uint32_t pipe = 0; per_pipe && pipe < 4; ++pipe)
                CHECK(best.at(own(pipe) + "_misses") <= other.at(own(pipe) + "_misses"));
            CHECK(best.at("texel_cache_misses") <= other.at("texel_cache_misses"));
        }
        CHECK(best.at("texel_cache_misses") <
              figures[work::Replacement::Lru].at("texel_cache_misses"));
    }
}

TEST_CASE("Optimal replacement of a cache that is written is refused, and lines that do not nest") {
    TimingConfig written;
    written.depth_cache.replacement = work::Replacement::Optimal;
    CHECK_THROWS_WITH(GpuTiming(written), Catch::Contains("depth_cache.replacement"));
    TimingConfig lines;
    lines.texel_l2.enable = true;
    lines.texel_l2.line_bytes = 32;
    CHECK_THROWS_WITH(GpuTiming(lines), Catch::Contains("texel_l2.line_bytes"));
}

TEST_CASE("Compressed textures: the same bytes from memory whether blocks or texels are held") {
    struct Kind {
        Format format;
        std::uint32_t block_bytes;
    };
    for (const Kind& kind : {Kind{Format::Dxt1Rgb, 8}, {Format::Dxt5, 16}}) {
        const std::uint64_t bytes = PictureSize * PictureSize / 16 * kind.block_bytes;
        for (const std::uint32_t line_bytes : {64u, 128u}) {
            TimingConfig config = wide_machine(1);
            config.memory.interleave_bytes = 128;
            config.texel_cache.sets = 4096;
            config.texel_cache.line_bytes = line_bytes;
            const Figures blocks = run(config, picture(kind.format));
            CHECK(blocks.at("texel_cache_misses") == bytes / line_bytes);
            CHECK(blocks.at("memory_texture_read_bytes") == bytes);
            config.texel_cache.contents = work::TexelContents::Texels;
            const Figures texels = run(config, picture(kind.format));
            CHECK(texels.at("texel_cache_misses") == PictureSize * PictureSize * 4 / line_bytes);
            CHECK(texels.at("texel_cache_read_bytes") == bytes);
            CHECK(texels.at("memory_texture_read_bytes") == bytes);
        }
    }
}

TEST_CASE("Expanding blocks takes its latency once, not for each quad") {
    for (const work::TexelContents contents :
         {work::TexelContents::Blocks, work::TexelContents::Texels}) {
        const auto cycles = [&](std::uint32_t latency, Format format) {
            TimingConfig config = wide_machine(1);
            config.texel_cache.fragment_fifo = 1024;
            config.texel_cache.outstanding_lines = 1024;
            config.texel_cache.contents = contents;
            config.texel_cache.decompress_cycles = latency;
            return run(config, picture(format)).at("total_cycles");
        };
        const std::uint64_t at_once = cycles(0, Format::Dxt1Rgb);
        for (const std::uint32_t latency : {1u, 20u, 200u}) {
            CHECK(cycles(latency, Format::Dxt1Rgb) >= at_once + latency);
            CHECK(cycles(latency, Format::Dxt1Rgb) <= at_once + latency + 2);
        }
        CHECK(cycles(200, Format::Rgba8) == cycles(0, Format::Rgba8));
    }
}

} // namespace
} // namespace ffgpu::timing
