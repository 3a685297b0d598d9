// Coarse depths, fast clear and compression on whole traces.

#include "tests/system/trace_run.h"

#include <catch2/catch.hpp>

namespace ffgpu::tools {
namespace {

using timing::CoarseDepth;

timing::TimingConfig all_on() {
    timing::TimingConfig config;
    config.hierarchical_depth.keeps = CoarseDepth::MinMax;
    config.depth_blocks.fast_clear = config.color_blocks.fast_clear = true;
    config.depth_blocks.compression = config.color_blocks.compression = true;
    return config;
}

TEST_CASE("Cleared depth in corridor is never read from memory") {
    timing::TimingConfig config;
    const Run plain = run_trace(own_trace("corridor"), {.timing = config});
    config.depth_blocks.fast_clear = true;
    const Run run = run_trace(own_trace("corridor"), {.timing = config});
    CHECK(run.pictures == plain.pictures);
    const auto& figures = run.timed;
    CHECK(figures.at("depth_blocks_cleared") > 0);
    CHECK(figures.at("depth_blocks_cleared_slowly") == 0);
    // The end of a frame empties the cache: what a frame looks up first was cleared before.
    const std::uint64_t line = config.depth_cache.line_bytes;
    CHECK(figures.at("depth_blocks_cleared_reads") >= figures.at("depth_cache_compulsory_misses"));
    CHECK(plain.timed.at("depth_cache_read_bytes") ==
          figures.at("depth_cache_read_bytes") + line * figures.at("depth_blocks_cleared_reads"));
}

TEST_CASE("Where the cache holds all of it, corridor's depth is not read at all") {
    timing::TimingConfig config;
    config.depth_cache.sets = 1 << 14; // 4 MB
    const Run plain = run_trace(own_trace("corridor"), {.timing = config, .last_frame = 1});
    config.depth_blocks.fast_clear = true;
    const Run run = run_trace(own_trace("corridor"), {.timing = config, .last_frame = 1});
    CHECK(plain.timed.at("depth_cache_read_bytes") > 0);
    CHECK(run.timed.at("depth_cache_read_bytes") == 0);
    CHECK(run.timed.at("memory_depth_read_bytes") == 0);
}

TEST_CASE("Whole traces with all features on: the same pictures, the same figures on any host") {
    for (const std::string& name : own_traces()) {
        INFO(name);
        const std::string path = own_trace(name);
        const Run plain = run_trace(path, {.last_frame = 1});
        const Run run = run_trace(path, {.timing = all_on(), .last_frame = 1});
        CHECK(run.pictures == plain.pictures);
        const Run other = run_trace(path,
                                    {.threads = 2,
                                     .tile_size = 16,
                                     .bin_bytes = 16384,
                                     .timing = all_on(),
                                     .last_frame = 1});
        CHECK(other.timed == run.timed);
        CHECK(other.cycles == run.cycles);
        CHECK(run.timed.at("color_blocks_compressed_writes") > 0);
    }
}

} // namespace
} // namespace ffgpu::tools
