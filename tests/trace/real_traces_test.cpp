// The traces of real programs beside the source tree, where they are installed.

#include "driver/trace/reader/trace_reader.h"

#include <cstdlib>
#include <filesystem>
#include <map>

#include <catch2/catch.hpp>

namespace ffgpu::trace {
namespace {

namespace fs = std::filesystem;

fs::path workloads() {
    if (const char* const path = std::getenv("FFGPU_WORKLOADS")) return path;
    return fs::path(FFGPU_SOURCE_DIR) / "../shared/workloads";
}

TEST_CASE("Real traces have the calls that apitrace lists") {
    // Counted by `apitrace dump --verbose`.
    const std::map<std::string, std::pair<unsigned, unsigned>> calls_and_swaps{
        {"billardgl", {79583, 6}},
        {"busyspheres", {111637, 4}},
        {"chromium", {48196, 9}},
        {"glxgears", {1608, 11}},
        {"lattice", {57839, 6}},
        {"openarena_dm", {47435, 7}},
        {"polyhedra", {9059, 6}},
        {"stairs", {5043, 6}},
    };
    for (const auto& [name, expected] : calls_and_swaps) {
        const fs::path path = workloads() / "traces" / (name + ".trace");
        if (!fs::exists(path)) {
            WARN("skipped: " << path.string() << " is not there");
            continue;
        }
        TraceReader reader(path.string());
        std::pair<unsigned, unsigned> found{};
        while (const Call* const call = reader.next()) {
            ++found.first;
            found.second += call->name() == "glXSwapBuffers";
        }
        INFO(name);
        CHECK(found == expected);
    }
}

} // namespace
} // namespace ffgpu::trace
