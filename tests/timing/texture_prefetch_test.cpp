// Latency tolerance of texture prefetching (H. Igehy, M. Eldridge, K. Proudfoot, Prefetching in a
// Texture Cache Architecture, 1998), through the whole machine: a fragment a cycle, a cycle more at
// the tags for each miss, a fragment FIFO, at most 64 lines outstanding, a line every four cycles
// from memory. The expected figures are those of an independent model of such a machine.
//
// What that machine does, and what a first reading misses: a fragment of k misses takes the tags
// for 1 + k cycles; the latency counts from the end of a line's transfer; and the machine without
// latency, to which all are compared, may have any number of lines outstanding.

#include "tests/timing/analytic_scenes.h"
#include "tests/timing/machine_figures.h"

#include <array>

#include <catch2/catch.hpp>

namespace ffgpu::timing {
namespace {

// The perspective floor, with no traffic but that of its texture.
const WorkBin& floor_bin() {
    static const WorkBin bin = [] {
        WorkBin made = make_bin(floor_scene(1024));
        auto state = std::make_shared<Registers>(*made.draws[0].state);
        state->blend.write_mask = 0;
        made.draws[0].state = state;
        return made;
    }();
    return bin;
}

// From the look-up to its data without `memory.latency`: to the arbiter, to the controller, and
// back; the paper's latency has none of these links.
constexpr std::uint32_t Links = 2;

TimingConfig prefetching(std::uint32_t latency, std::uint32_t fifo) {
    TimingConfig config;
    config.raster.granularity = work::Granularity::Fragment;
    config.raster.tile_cycles = 0;
    config.texture.miss_cycles = 1;
    TexelCacheConfig& cache = config.texel_cache;
    cache.sets = 128; // 16 KB
    cache.ways = 2;
    cache.lookups_per_cycle = 8;
    cache.bilinear_quads_per_cycle = 2; // a trilinear fragment a cycle
    cache.fragment_fifo = fifo;
    cache.outstanding_lines = cache.request_queue = 64;
    MemoryConfig& memory = config.memory;
    memory.profile = MemoryProfile::Ideal;
    memory.apply_profile();
    memory.channels = 1;
    memory.bytes_per_cycle = 16;
    memory.queue = memory.client_queue = 64;
    memory.scheduler = SchedulerKind::InOrder;
    memory.latency = latency > Links ? latency - Links : 0;
    return config;
}

double cycles(const TimingConfig& config) {
    return static_cast<double>(run(config, floor_bin()).at("total_cycles"));
}

TEST_CASE("E5: the speed of a prefetching texture unit by FIFO and latency", "[tables]") {
    TimingConfig unlimited = prefetching(0, 65536);
    unlimited.texel_cache.outstanding_lines = 65536;
    const double best = cycles(unlimited);
    constexpr std::array<std::uint32_t, 5> Latencies{10, 25, 50, 100, 250};
    struct Row {
        std::uint32_t fifo;
        std::array<double, 5> percent; // of the machine without latency
    };
    for (const Row& row : {Row{8, {74.9, 50.0, 31.9, 18.4, 8.1}},
                           {16, {93.8, 71.1, 47.2, 27.9, 12.5}},
                           {32, {97.3, 95.6, 72.3, 44.1, 20.1}},
                           {64, {97.6, 97.5, 97.3, 73.0, 34.3}},
                           {128, {98.2, 98.1, 97.9, 97.5, 61.6}},
                           {256, {98.9, 98.8, 98.6, 98.3, 96.9}}}) {
        for (std::size_t i = 0; i < Latencies.size(); ++i) {
            INFO("FIFO " << row.fifo << ", latency " << Latencies[i]);
            CHECK(100 * best / cycles(prefetching(Latencies[i], row.fifo)) ==
                  Approx(row.percent[i]).margin(0.1));
        }
    }
}

TEST_CASE("E5: a blocking cache") {
    // A FIFO of one fragment. This row's latency counts from the request, the transfer included.
    constexpr std::uint32_t Transfer = 4, Request = 1;
    TimingConfig unlimited = prefetching(0, 65536);
    unlimited.texel_cache.outstanding_lines = 65536;
    const double best = cycles(unlimited);
    for (const auto& [latency, percent] :
         {std::pair{10u, 53.0}, {25u, 31.1}, {50u, 18.4}, {100u, 10.1}, {250u, 4.3}}) {
        TimingConfig blocking = prefetching(latency, 1);
        blocking.memory.latency = latency - Transfer - Request;
        INFO("latency " << latency);
        CHECK(100 * best / cycles(blocking) == Approx(percent).margin(0.1));
    }
}

} // namespace
} // namespace ffgpu::timing
