// `ffgpu diff` with Verilated units on a side: equal where they are, and of a fault in any unit the
// stage that it shows in first, with quad, lane and field.

#include "model/capture/capture_writer.h"
#include "tests/gpu/busy_scene.h"
#include "tests/support/temporary_file.h"
#include "tests/tools/tool.h"
#include "tools/diff/difference.h"
#include "tools/rtl/rtl_comparison.h"

#include <catch2/catch.hpp>
#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

using Catch::Contains;
using Catch::EndsWith;

// A unit's field that is wrong from its N-th output on, and the stage's field that it shows in.
// What of it does not change a value at once shows later: there the place is not the unit's first.
struct Shown {
    const char *unit, *field, *part, *part_field;
    std::uint64_t from = 0;
    bool at_once = true;
};
constexpr std::array Faults{
    Shown{"tile_walker", "live", "coverage", "covered"},     // one too many
    Shown{"tile_walker", "live", "coverage", "covered", 90}, // one too few
    Shown{"tile_walker", "x", "coverage", "covered"},
    Shown{"depth_plane", "depths", "depth", "depth"},
    Shown{"attribute_plane", "values", "perspective", "w", 0, false},
    Shown{"reciprocal", "value", "perspective", "w"},
    Shown{"perspective", "values", "perspective", "w", 0, false},
    Shown{"perspective", "values", "colors", "primary", 50},
    Shown{"level_of_detail", "level", "texture 0", "sample", 0, false},
    Shown{"level_of_detail", "linear", "texture 0", "sample", 0, false},
    Shown{"texel_address", "weight_x", "texture 0", "sample", 50},
    Shown{"texel_address", "places", "texture 0", "sample", 0, false},
    Shown{"texel_decode", "color", "texture 0", "sample"},
    Shown{"filter_tree", "color", "texture 0", "sample"},
    Shown{"texture_environment", "color", "environment 0", "color"},
    Shown{"color_sum", "color", "color_sum", "color"},
    Shown{"fog", "color", "fog", "color"},
    Shown{"apply_coverage", "color", "antialias", "color"},
    Shown{"alpha_test", "live", "alpha_test", "passed"},
    Shown{"alpha_test", "live", "alpha_test", "passed", 400}, // where it is switched off
    Shown{"stencil_depth", "live", "stencil_depth", "passed_depth"},
    Shown{"stencil_depth", "pixels", "stencil_depth", "new_stencil"},
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

// As diff names a fragment.
std::string place_of(const rtl::StageDifference& found) {
    return fmt::format("quad {},{} lane {}", found.x, found.y, found.lane);
}

TEST_CASE(
    "Of a fault in a Verilated unit diff names the stage, the place, the field and the unit") {
    const TemporaryFile capture("", ".ffc");
    write_capture(capture.path());
    for (const Shown& fault : Faults) {
        INFO(fault.unit << ' ' << fault.field << " from output " << fault.from);
        const auto stages =
            open_rtl_stages({.units = {fault.unit},
                             .fault = rtl::PlantedFault{fault.unit, fault.field, fault.from}});
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
        draw_up_to(capture.path(), stages->table(), {}, found->command);
        const auto unit = stages->take_difference();
        REQUIRE(unit);
        CHECK(unit->unit == fault.unit);
        CHECK(unit->expected != unit->got);
        if (fault.at_once) CHECK_THAT(entry.place, Contains(place_of(*unit)));
    }
}

// A square without any test.
TEST_CASE("A stage that is switched off and does something is named, not the next one") {
    const TemporaryFile capture("", ".ffc");
    test::Scene scene(8, 8);
    capture::CaptureWriter writer(scene.gpu);
    writer.begin(capture.path(), 0);
    scene.into = &writer;
    const auto corner = [](float x, float y) { return test::Vertex{x, y, 0, 1, 1, 1, 1, 1, 0, 0}; };
    scene.draw(PrimitiveType::TriangleFan,
               {corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)});
    writer.finish();
    writer.frame_shown(0, scene.registers.targets.color[0]);
    writer.end();
    for (const auto& [unit, field] :
         {std::pair{"alpha_test", "passed"}, std::pair{"stencil_depth", "passed_depth"}}) {
        INFO(unit);
        const auto stages =
            open_rtl_stages({.units = {unit}, .fault = rtl::PlantedFault{unit, "live", 0}});
        const auto found =
            find_difference({.a = {.input = capture.path()},
                             .b = {.input = capture.path(), .stages = &stages->table()},
                             .question = {}});
        REQUIRE(found);
        REQUIRE(found->entries.size() == 1);
        CHECK(found->entries[0].part == unit);
        CHECK(found->entries[0].field == field);
        CHECK(found->entries[0].a == "1");
        CHECK(found->entries[0].b == "0");
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
    for (const char* const backend : {"rtl:bland", "rtl:fragment_pipe", "rtl:", "rtl:,"}) {
        INFO(backend);
        std::string differences;
        const std::string text = printed(stderr, [&] { differences = diff(backend); });
        CHECK(status == 2);
        CHECK_THAT(text, Contains("; there are all, tile_walker") && EndsWith(", blend\n"));
        CHECK_THAT(differences, !Contains("Equal"));
    }
    for (const char* const cycles : {"9-3", "some"}) {
        status = run({"diff",
                      capture.path(),
                      "--backend-b",
                      "rtl:fog",
                      "--fst",
                      "waves",
                      "--fst-cycles",
                      cycles});
        CHECK(status == 2);
    }
    diff("plain");
    CHECK(status == 2);
}

} // namespace
} // namespace ffgpu::tools
