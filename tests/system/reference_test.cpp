// The scalar specifications draw whole frames, and draw them as the fast forms do.

#include "tests/system/trace_run.h"

#include <catch2/catch.hpp>

namespace ffgpu::tools {
namespace {

constexpr std::uint64_t LastFrame = 1;

void require_equal_frames(const std::string& path) {
    INFO(path);
    const Run fast = run_trace(path, {.threads = 2, .last_frame = LastFrame});
    const Run reference =
        run_trace(path, {.threads = 2, .reference = true, .last_frame = LastFrame});
    REQUIRE(fast.pictures.size() == LastFrame + 1);
    CHECK(reference.pictures == fast.pictures);
    CHECK(reference.functional == fast.functional);
}

TEST_CASE("The scalar specifications draw the frames and count the work of the fast forms") {
    for (const std::string& name : own_traces())
        require_equal_frames(own_trace(name));
}

TEST_CASE("They draw the frames of programs of others", "[workloads]") {
    const std::vector<std::string> names = workload_traces();
    for (std::size_t i = 0; i < names.size() && i < 3; ++i)
        require_equal_frames(workload_trace(names[i]));
}

} // namespace
} // namespace ffgpu::tools
