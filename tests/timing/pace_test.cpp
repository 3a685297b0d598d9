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

    bool operator==(const Outcome&) const = default;
};

Outcome run_frames(const TimingConfig& config, std::uint64_t seed, const Evaluation& evaluation) {
    GpuTiming timing(config, evaluation);
    Outcome outcome;
    timing.set_on_frame([&](const FrameTiming& frame) {
        for (const CommandCycles& command : frame.commands)
            outcome.cycles.push_back(command.cycles);
    });
    RandomWork work(seed);
    for (const std::uint32_t frame : {0u, 1u}) {
        for (const auto& command : work.frame(6))
            timing.command(command);
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
        CHECK(run_frames(config, seed, {0, Pace::Decoupled}) == expected);
    }
}

} // namespace
} // namespace ffgpu::timing
