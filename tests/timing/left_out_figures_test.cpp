// What exporters listen to: the requests of a machine that counts no figures, and whose frames
// overlap, are those of one that counts them all and ends each frame before the next is told.

#include "model/timing/gpu_timing.h"
#include "model/timing/memory_observer.h"
#include "tests/timing/random_work.h"

#include <tuple>
#include <vector>

#include <catch2/catch.hpp>

namespace ffgpu::timing {
namespace {

// Address, bytes, whether it writes, client, cycle, and whether that is the cycle of its end.
using Event = std::tuple<std::uint64_t, std::uint32_t, bool, Client, std::uint64_t, bool>;

class Listener final : public MemoryObserver {
public:
    std::vector<Event> events;

private:
    void note(const MemoryRequest& request, std::uint64_t cycle, bool ends) {
        events.emplace_back(
            request.address, request.bytes, request.write, request.client, cycle, ends);
    }
    void sent(const MemoryRequest& request, std::uint64_t cycle) override {
        note(request, cycle, false);
    }
    void done(const MemoryRequest& request, std::uint64_t cycle) override {
        note(request, cycle, true);
    }
};

struct Outcome {
    std::vector<Event> events;
    std::vector<std::vector<std::uint64_t>> cycles; // of each frame's commands
    std::uint64_t end = 0;

    bool operator==(const Outcome&) const = default;
};

TimingConfig random_machine(std::uint64_t seed) {
    TimingConfig config = RandomWork(~seed).machine();
    config.bottlenecks.enable = false;
    return config;
}

Outcome run_frames(std::uint64_t seed, const TimingConfig& config, bool leaves_out) {
    GpuTiming timing(config);
    Listener listener;
    timing.set_memory_observer(&listener);
    Outcome outcome;
    timing.set_on_frame([&](const FrameTiming& frame) {
        outcome.cycles.emplace_back();
        for (const CommandCycles& command : frame.commands)
            outcome.cycles.back().push_back(command.cycles);
    });
    if (leaves_out) {
        timing.leave_out_figures();
        timing.let_frames_overlap();
    }
    RandomWork work(seed);
    for (std::uint32_t frame = 0; frame < 3; ++frame) {
        for (const auto& command : work.frame(5))
            timing.command(command);
        timing.end_frame(frame);
    }
    timing.catch_up();
    outcome.events = std::move(listener.events);
    outcome.end = timing.cycles();
    return outcome;
}

TEST_CASE("no request and no cycle depends on whether figures are counted and frames overlap") {
    for (std::uint64_t seed = 500; seed < 560; ++seed) {
        const TimingConfig config = random_machine(seed);
        const Outcome expected = run_frames(seed, config, false);
        CAPTURE(seed);
        CHECK(!expected.events.empty());
        CHECK(expected.cycles.size() == 3);
        CHECK(run_frames(seed, config, true) == expected);
    }
}

// A channel without a place is looked at when what is on its way to it arrives.
TEST_CASE("nor where many wait for a place in a channel whose queue is short") {
    for (std::uint64_t seed = 560; seed < 600; ++seed) {
        TimingConfig config = random_machine(seed);
        config.raster.quads_per_cycle = 4;
        config.memory.channels = 8;
        config.memory.queue = 1 + static_cast<std::uint32_t>(seed % 3);
        config.memory.latency = static_cast<std::uint32_t>(seed % 7);
        CAPTURE(seed);
        CHECK(run_frames(seed, config, true) == run_frames(seed, config, false));
    }
}

} // namespace
} // namespace ffgpu::timing
