// A latency a hundred times as long costs its difference once for each time that data are waited
// for behind each other, where the queues hold what is under way meanwhile.

#include "tests/timing/analytic_scenes.h"
#include "tests/timing/front_end_scenes.h"

#include <catch2/catch.hpp>

namespace ffgpu::timing {
namespace {

constexpr std::uint32_t Short = 20, Long = 2000;

// Everything that waits for memory has room for all of it.
TimingConfig deep_queues() {
    TimingConfig config = wide_front_end();
    config.vertex.fetch_queue = config.vertex.index_queue = 4096;
    config.vertex.index_cache_lines = 64;
    config.vertex.outstanding_lines = 4096;
    config.vertex.request_queue = config.vertex.miss_queue = 1024;
    config.memory.queue = config.memory.client_queue = 1024;
    const auto deepen = [](auto& cache) {
        cache.fragment_fifo = cache.outstanding_lines = 65536;
        cache.request_queue = cache.miss_queue = 1024;
    };
    deepen(config.texel_cache);
    deepen(config.depth_cache);
    deepen(config.color_cache);
    config.texel_l2.queue = config.texel_l2.outstanding_lines = 1024;
    config.texel_l2.request_queue = config.texel_l2.miss_queue = 1024;
    return config;
}

// What the longer latency of the memory costs.
std::uint64_t cost(TimingConfig config, const WorkBin& bin) {
    const auto cycles = [&](std::uint32_t latency, std::uint32_t order) {
        config.memory.latency = latency;
        return run(config, bin, order).at("total_cycles");
    };
    return cycles(Long, 1) - cycles(Short, 0);
}

// One wait behind another: of the short ones some cycles may hide behind other work, of the long
// ones none.
void check_waits(std::uint64_t cost, std::uint64_t waits) {
    CHECK(cost <= waits * (Long - Short));
    CHECK(cost > waits * (Long - Short) - 2 * Short);
}

TEST_CASE("a hundred times the memory's latency costs vertex fetch one fill, with indices two") {
    WorkBin bin = triangles(1000, Culled);
    CHECK(cost(deep_queues(), bin) == Long - Short);
    bin.draws[0].geometry.index_address = 1 << 20;
    bin.draws[0].geometry.index_bytes = 2;
    check_waits(cost(deep_queues(), bin), 2);
    TimingConfig shallow = deep_queues();
    shallow.vertex.outstanding_lines = 64;
    CHECK(cost(shallow, bin) > 5 * (Long - Short));
}

// The second wait is the frame's end: for the last line that the colour cache writes.
TEST_CASE(
    "a hundred times the memory's latency costs a textured draw one fill and the last write") {
    const WorkBin bin = make_bin(planar_scene(64));
    for (const bool second_level : {false, true})
        for (const bool per_pipe : {false, true}) {
            INFO("second level " << second_level << ", caches of each pipe's own " << per_pipe);
            TimingConfig config = deep_queues();
            config.texel_l2.enable = second_level;
            config.texel_cache.per_pipe = per_pipe;
            config.raster.quads_per_cycle = per_pipe ? 4 : 1;
            CHECK(cost(config, bin) == 2 * (Long - Short));
        }
}

TEST_CASE("a hundred times the second level's latency costs its difference once") {
    const WorkBin bin = make_bin(planar_scene(64));
    for (const std::uint32_t pipes : {1u, 4u}) {
        TimingConfig config = deep_queues();
        config.texel_l2.enable = true;
        config.texel_cache.per_pipe = true;
        config.raster.quads_per_cycle = pipes;
        const auto cycles = [&](std::uint32_t latency, std::uint32_t order) {
            config.texel_l2.latency = latency;
            return run(config, bin, order).at("total_cycles");
        };
        INFO(pipes << " pipes");
        CHECK(cycles(800, 1) - cycles(8, 0) == 800 - 8);
    }
}

// Depth is read, so is the destination's colour: each cache behind the other waits for its first
// line, and the end of the frame for the last that is written.
TEST_CASE("a hundred times the memory's latency costs each cache behind another one fill") {
    WorkBin bin = make_bin(planar_scene(64), MaxSamples);
    check_waits(cost(deep_queues(), bin), 3);
}

TEST_CASE("a hundred times the memory's latency costs uploads and clears their last write") {
    WorkBin bin;
    WorkDraw& clear = bin.draws.emplace_back();
    clear.kind = WorkKind::Clear;
    clear.clear.color = true;
    Registers registers;
    registers.targets.color[0] = {1 << 22, Format::Rgba8, 256, 256, 1024};
    registers.scissor = {0, 0, 256, 256};
    clear.state = std::make_shared<Registers>(registers);
    bin.transfers.push_back({.before_draw = 0, .is_write = true, .at = 1 << 16, .bytes = 65536});
    CHECK(cost(deep_queues(), bin) == Long - Short);
}

} // namespace
} // namespace ffgpu::timing
