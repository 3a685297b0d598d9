// `ffgpu diff` with Verilated units on a side: equal where they are, and of a fault in any unit the
// stage that it shows in first, with quad, lane and field.

#include "model/capture/capture_writer.h"
#include "tests/gpu/busy_scene.h"
#include "tests/support/temporary_file.h"
#include "tests/tools/tool.h"
#include "tools/diff/difference.h"
#include "tools/rtl/rtl_comparison.h"

#include <catch2/catch.hpp>

namespace ffgpu::tools {
namespace {

using Catch::Contains;

// A unit's field that is wrong from its first output on, and where that shows first.
struct Shown {
    const char *unit, *field, *part, *part_field;
};
constexpr std::array Faults{Shown{"depth_plane", "depths", "depth", "depth"},
                            Shown{"texel_decode", "color", "texture 0", "sample"},
                            Shown{"filter_tree", "color", "texture 0", "sample"},
                            Shown{"texture_environment", "color", "environment 0", "color"},
                            Shown{"color_sum", "color", "color_sum", "color"},
                            Shown{"fog", "color", "fog", "color"},
                            Shown{"alpha_test", "live", "alpha_test", "passed"},
                            Shown{"blend", "pixels", "color_write 0", "stored"}};

void write_capture(const std::string& path) {
    test::Scene scene(32, 24);
    capture::CaptureWriter writer(scene.gpu);
    writer.begin(path, 0);
    scene.into = &writer;
    test::draw_mixture(scene, [&](int draw) { return test::vary_busily(scene.registers, draw); });
    writer.finish();
    writer.frame_shown(0, scene.registers.targets.color[0]);
    writer.end();
}

TEST_CASE("Of a fault in a Verilated unit diff names the stage, the place and the field") {
    const TemporaryFile capture("", ".ffc");
    write_capture(capture.path());
    for (const Shown& fault : Faults) {
        INFO(fault.unit);
        const auto stages = open_rtl_stages(
            {.units = {fault.unit}, .fault = rtl::PlantedFault{fault.unit, fault.field, 0}});
        const auto found =
            find_difference({.a = {.input = capture.path()},
                             .b = {.input = capture.path(), .stages = &stages->table()},
                             .question = {}});
        REQUIRE(found);
        REQUIRE(found->entries.size() == 1);
        const DifferentEntry& entry = found->entries[0];
        CHECK(entry.part == fault.part);
        CHECK(entry.field == fault.part_field);
        CHECK(entry.a != entry.b);
        CHECK_THAT(entry.place, Contains("quad ") && Contains(" lane "));
    }
}

TEST_CASE("diff --backend-b rtl draws with all units, rtl:UNIT with these") {
    const TemporaryFile capture("", ".ffc");
    write_capture(capture.path());
    int status = -1;
    const auto diff = [&](const std::string& backend) {
        return printed(stdout, [&] {
            status = run({"diff", capture.path(), "--backend-b", backend});
        });
    };
    CHECK_THAT(diff("rtl"), Contains("Equal: every command"));
    CHECK(status == 0);
    CHECK_THAT(diff("rtl:fog,blend"), Contains("Equal: every command"));
    CHECK(status == 0);
    diff("rtl:bland");
    CHECK(status == 2);
    diff("plain");
    CHECK(status == 2);
}

} // namespace
} // namespace ffgpu::tools
