// Histograms: what stands in them is what happened, and all of it.

#include "docs/examples/latency_memory.h"
#include "model/timing/histogram.h"
#include "model/timing/link.h"
#include "tests/timing/machine_figures.h"
#include "tests/timing/random_work.h"

#include <bit>
#include <numeric>

#include <catch2/catch.hpp>

namespace ffgpu::timing {
namespace {

using Counts = std::map<std::string, std::vector<std::uint64_t>>;

Counts counts_of(const GpuTiming& timing) {
    Counts counts;
    for (const Histogram* const histogram : timing.histograms())
        counts[histogram->name()] = histogram->counts();
    return counts;
}

std::uint64_t sum(const std::vector<std::uint64_t>& counts) {
    return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
}

std::uint64_t weighted(const std::vector<std::uint64_t>& counts) {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < counts.size(); ++i)
        sum += i * counts[i];
    return sum;
}

TEST_CASE("a queue's cycles at each number of items are all cycles, and give its item cycles") {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const TimingConfig config = RandomWork(~seed).machine();
        GpuTiming timing(config);
        RandomWork work(seed);
        for (const auto& command : work.frame(5))
            timing.command(command);
        timing.end_frame(0);
        const Figures figures = figures_of(timing);
        unsigned queues = 0;
        for (const auto& [name, counts] : counts_of(timing)) {
            if (name.rfind("queue_", 0) != 0) continue;
            ++queues;
            CAPTURE(seed, name);
            CHECK(sum(counts) == figures.at("total_cycles"));
            const std::string queue = name.substr(0, name.size() - std::string("items").size());
            CHECK(weighted(counts) == figures.at(queue + "item_cycles"));
        }
        CHECK(queues > 20);
    }
}

TEST_CASE("a draw that waits to be decoded is the one item of its queue for as long") {
    TimingConfig config;
    config.command_processor.draw_cycles = 1000;
    config.host.bytes_per_cycle = 0;
    GpuTiming timing(config);
    RandomWork work(1);
    timing.command(std::make_shared<work::WholeCommand>(work.draw(0, 3, 1)));
    timing.end_frame(0);
    // The frame's end waits behind it. The draw comes in some cycle n, is seen and decoded in
    // n + 1 ... n + 1000, and is gone at the end of the last of them.
    const std::vector<std::uint64_t> commands = counts_of(timing).at("queue_commands_items");
    const Figures figures = figures_of(timing);
    CHECK(commands[2] == 1000);
    CHECK(std::accumulate(commands.begin() + 3, commands.end(), std::uint64_t{0}) == 0);
    CHECK(sum(commands) == figures.at("total_cycles"));
}

// The sizes of the pieces and the lanes of the quads, told anew from the work.
struct Expected {
    std::vector<std::uint64_t> pixels = std::vector<std::uint64_t>(28),
                               covered = std::vector<std::uint64_t>(5),
                               written = std::vector<std::uint64_t>(5);

    void add(const work::WholeCommand& command) {
        std::map<std::uint32_t, unsigned> size; // by primitive, which is one piece
        for (const WorkQuad& quad : command.quads) {
            unsigned lanes = 0, alive = 0;
            for (unsigned lane = 0; lane < 4; ++lane) {
                lanes += quad.covered >> lane & 1u;
                alive += quad.after_depth >> lane & 1u;
            }
            size[quad.primitive] += lanes;
            ++covered[lanes];
            ++written[alive];
        }
        for (const auto& [primitive, pixels_of] : size) {
            std::size_t range = 0;
            while (pixels_of >> range != 0)
                ++range;
            ++pixels[range];
        }
    }
};

std::vector<std::uint64_t> padded(std::vector<std::uint64_t> counts, std::size_t size) {
    counts.resize(size);
    return counts;
}

TEST_CASE("sizes of pieces and lanes of quads are the work's, whatever the machine makes of it") {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        CAPTURE(seed);
        const TimingConfig config = RandomWork(~seed).machine();
        GpuTiming timing(config);
        std::vector<CommandCycles> commands;
        timing.set_on_frame([&](const FrameTiming& frame) { commands = frame.commands; });
        RandomWork work(seed);
        Expected expected;
        for (std::uint32_t number = 0; number < 4; ++number) {
            const auto command =
                std::make_shared<work::WholeCommand>(work.draw(number, 60, work.below(800)));
            expected.add(*command);
            timing.command(command);
        }
        timing.end_frame(0);
        const Counts counts = counts_of(timing);
        CHECK(padded(counts.at("piece_pixels"), 28) == expected.pixels);
        CHECK(padded(counts.at("quad_lanes_covered"), 5) == expected.covered);
        CHECK(padded(counts.at("quad_lanes_written"), 5) == expected.written);
        CHECK(counts.at("piece_samples").empty());
        std::uint64_t quads = 0;
        for (const CommandCycles& command : commands)
            for (const std::uint32_t count : command.shape.quad_lanes_covered)
                quads += count;
        CHECK(quads == sum(expected.covered));
    }
}

TEST_CASE("latencies of a memory of one latency stand in one range, as many as requests") {
    constexpr Cycle Latency = 300;
    TimingConfig config;
    GpuTiming timing(config, 0, [](const Clock& clock, const MemoryConfig&) {
        return std::make_unique<examples::LatencyMemory>(
            "latency", clock, [](const MemoryRequest&) { return Latency; });
    });
    RandomWork work(4);
    for (std::uint32_t number = 0; number < 4; ++number)
        timing.command(std::make_shared<work::WholeCommand>(work.draw(number, 100, 500)));
    timing.end_frame(0);
    const Figures figures = figures_of(timing);
    const Counts counts = counts_of(timing);
    for (const std::string_view client : ClientNames) {
        const std::string prefix = "memory_" + std::string(client) + '_';
        CAPTURE(prefix);
        const auto& reads = counts.at(prefix + "read_latency");
        const auto& writes = counts.at(prefix + "write_latency");
        CHECK(sum(reads) + sum(writes) == figures.at(prefix + "requests"));
        // Nothing comes back sooner than the memory answers, and the mean lies in the ranges.
        for (const auto& [ranges, cycles] :
             {std::pair(reads, figures.at(prefix + "read_latency_cycles")),
              std::pair(writes, figures.at(prefix + "write_latency_cycles"))}) {
            std::uint64_t least = 0, most = 0;
            for (std::size_t i = 1; i < ranges.size(); ++i) {
                least += ranges[i] << (i - 1);
                most += ranges[i] * ((std::uint64_t{1} << i) - 1);
                if (i < 9) CHECK(ranges[i] == 0); // 256 to 511 is range 9
            }
            CHECK(least <= cycles);
            CHECK(cycles <= most);
            CHECK(cycles >= sum(ranges) * Latency);
        }
    }
    CHECK(sum(counts.at("memory_texture_read_latency")) > 0);
    CHECK(sum(counts.at("memory_color_write_latency")) > 0);
}

} // namespace
} // namespace ffgpu::timing
