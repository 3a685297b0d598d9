// Frames that overlap: the next is made ready while the machine runs one. What is read on the
// machine's thread at a frame's end is what a machine has that ends each frame before the next.

#include "tests/timing/machine_figures.h"
#include "tests/timing/random_work.h"

#include <stdexcept>
#include <thread>
#include <vector>

#include <catch2/catch.hpp>

namespace ffgpu::timing {
namespace {

constexpr std::uint32_t Frames = 4;

void tell_frame(RandomWork& work, GpuTiming& timing, std::uint32_t frame) {
    for (const auto& command : work.frame(4))
        timing.command(command);
    timing.end_frame(frame);
}

std::vector<Figures> figures_of_frames(std::uint64_t seed, bool overlap) {
    GpuTiming timing(RandomWork(~seed).machine());
    if (overlap) timing.let_frames_overlap();
    std::vector<Figures> figures;
    RandomWork work(seed);
    for (std::uint32_t frame = 0; frame < Frames; ++frame) {
        tell_frame(work, timing, frame);
        if (overlap)
            timing.post([&] { figures.push_back(figures_of(timing)); });
        else
            figures.push_back(figures_of(timing));
    }
    timing.catch_up();
    return figures;
}

TEST_CASE("figures at the ends of frames that overlap are those of frames one by one") {
    for (std::uint64_t seed = 700; seed < 730; ++seed) {
        const std::vector<Figures> expected = figures_of_frames(seed, false);
        CAPTURE(seed);
        REQUIRE(expected.size() == Frames);
        CHECK(expected[0].at("total_cycles") < expected[1].at("total_cycles"));
        CHECK(figures_of_frames(seed, true) == expected);
    }
}

TEST_CASE(
    "a job is called behind what was told before it, on one thread that is not the teller's") {
    GpuTiming timing(TimingConfig{});
    timing.let_frames_overlap();
    std::vector<std::uint32_t> order; // a frame's end, and the job behind it
    std::vector<std::thread::id> threads;
    timing.set_on_frame([&](const FrameTiming& frame) {
        order.push_back(frame.frame);
        threads.push_back(std::this_thread::get_id());
    });
    RandomWork work(731);
    for (std::uint32_t frame = 0; frame < Frames; ++frame) {
        tell_frame(work, timing, frame);
        timing.post([&, frame] {
            order.push_back(100 + frame);
            threads.push_back(std::this_thread::get_id());
        });
    }
    timing.catch_up();
    CHECK(order == std::vector<std::uint32_t>{0, 100, 1, 101, 2, 102, 3, 103});
    CHECK(threads == std::vector<std::thread::id>(order.size(), threads.front()));
    CHECK(threads.front() != std::this_thread::get_id());
}

TEST_CASE("what a job throws comes out once, and nothing behind it is done") {
    GpuTiming timing(TimingConfig{});
    timing.let_frames_overlap();
    unsigned calls = 0;
    RandomWork work(732);
    const auto tell = [&] {
        tell_frame(work, timing, 0);
        timing.post([&] {
            ++calls;
            throw std::runtime_error("the disk is full");
        });
        tell_frame(work, timing, 1);
        timing.post([&] { ++calls; });
        timing.catch_up();
    };
    CHECK_THROWS_WITH(tell(), "the disk is full");
    CHECK(calls == 1);
    CHECK_NOTHROW(timing.catch_up());
    CHECK(calls == 1);
}

} // namespace
} // namespace ffgpu::timing
