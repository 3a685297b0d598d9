// Units that sleep and a clock that jumps change no figure: the machine that calls every unit in
// every cycle has the same.

#include "tests/timing/machine_figures.h"
#include "tests/timing/random_work.h"

#include <catch2/catch.hpp>

namespace ffgpu::timing {
namespace {

struct Outcome {
    Figures figures;
    std::vector<std::uint64_t> cycles; // of each command
    std::vector<WaitedCycles> waited;

    bool operator==(const Outcome&) const = default;
};

// `catches_up`: the machine runs as far as it can after every command.
Outcome run_frames(const TimingConfig& config,
                   std::uint64_t seed,
                   const Evaluation& evaluation,
                   bool catches_up = false) {
    GpuTiming timing(config, evaluation);
    Outcome outcome;
    timing.set_on_frame([&](const FrameTiming& frame) {
        for (const CommandCycles& command : frame.commands) {
            outcome.cycles.push_back(command.cycles);
            outcome.waited.push_back(command.waited);
        }
    });
    RandomWork work(seed);
    for (const std::uint32_t frame : {0u, 1u}) {
        for (const auto& command : work.frame(6)) {
            timing.command(command);
            if (catches_up) timing.catch_up();
        }
        timing.end_frame(frame);
    }
    outcome.figures = figures_of(timing);
    return outcome;
}

TEST_CASE("every pace of the clock has the figures of the walk through every unit and cycle") {
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        const TimingConfig config = RandomWork(~seed).machine();
        const Outcome expected = run_frames(config, seed, {0, Pace::EveryCycle});
        CAPTURE(seed);
        CHECK(expected.figures.at("total_cycles") > 0);
        CHECK(run_frames(config, seed, {0, Pace::Lockstep}) == expected);
        const auto order = static_cast<std::uint32_t>(seed); // 0: that of the pipe
        CHECK(run_frames(config, seed, {order, Pace::Decoupled}) == expected);
    }
}

TEST_CASE("whether anybody looks what is waited for is in no other figure") {
    const auto without_waits = [](Outcome outcome) {
        std::erase_if(outcome.figures, [](const auto& figure) {
            return figure.first.starts_with("bottleneck_") || figure.first.starts_with("gain_");
        });
        outcome.waited.clear();
        return outcome;
    };
    for (std::uint64_t seed = 100; seed < 130; ++seed) {
        TimingConfig config = RandomWork(~seed).machine();
        const Outcome looked = run_frames(config, seed, {});
        config.bottlenecks.enable = false;
        const Outcome unlooked = run_frames(config, seed, {});
        CAPTURE(seed);
        CHECK(without_waits(unlooked) == without_waits(looked));
        for (const auto& [name, value] : unlooked.figures)
            if (name.starts_with("bottleneck_") || name.starts_with("gain_")) CHECK(value == 0);
    }
}

TEST_CASE("how often the machine waits for the host is in no figure") {
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        TimingConfig config = RandomWork(~seed).machine();
        config.host.queue = 1;          // It does not run while as few are told
        config.memory.client_queue = 2; // as can end in a cycle.
        config.host.bytes_per_cycle = 5 + static_cast<std::uint32_t>(seed); // no whole command's
        CAPTURE(seed);
        CHECK(run_frames(config, seed, {}, true) == run_frames(config, seed, {}, false));
    }
}

} // namespace
} // namespace ffgpu::timing
