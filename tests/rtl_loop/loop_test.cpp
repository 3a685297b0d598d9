// Verilated units as the functional GPU's stages: frames are the model's, what a unit gets wrong is
// told with the draw and the unit, and a build without Verilator says that it is one.

#include "tests/gpu/busy_scene.h"
#include "tests/support/temporary_file.h"
#include "tests/tools/tool.h"
#include "tools/rtl/rtl_comparison.h"

#include <algorithm>

#include <catch2/catch.hpp>
#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

using Catch::Contains;
using Catch::EndsWith;
using rtl::StageShare;

struct UnitField {
    const char *unit, *field;
};

// Every unit, and a field of its outputs.
constexpr std::array Units{UnitField{"tile_walker", "live"},
                           UnitField{"depth_plane", "depths"},
                           UnitField{"attribute_plane", "values"},
                           UnitField{"reciprocal", "value"},
                           UnitField{"perspective", "values"},
                           UnitField{"level_of_detail", "linear"},
                           UnitField{"texel_address", "weight_x"},
                           UnitField{"texel_decode", "color"},
                           UnitField{"filter_tree", "color"},
                           UnitField{"texture_environment", "color"},
                           UnitField{"color_sum", "color"},
                           UnitField{"fog", "color"},
                           UnitField{"apply_coverage", "color"},
                           UnitField{"alpha_test", "live"},
                           UnitField{"stencil_depth", "pixels"},
                           UnitField{"blend", "pixels"}};

// The busy scene's draws on a small picture, compared after each.
void draw_on(RtlComparison& comparison) {
    test::Scene scene(32, 24, {.stages = &comparison.stages()});
    comparison.attach(scene.gpu, scene.gpu);
    scene.into = &comparison;
    test::draw_mixture(scene, [&](int draw) { return test::vary_busily(scene.registers, draw); });
}

TEST_CASE("Verilated units draw the busy scene as the model does, and all of it passes them") {
    RtlComparison comparison({.units = {"all"}});
    const test::BusyPicture drawn = test::draw_busy_scene({.stages = &comparison.stages()});
    CHECK(drawn == test::draw_busy_scene({}));
    const std::vector<StageShare> shares = comparison.shares();
    for (const UnitField& unit : Units) {
        INFO(unit.unit);
        const auto counts = [&](const StageShare& share) {
            return share.units.find(unit.unit) != std::string::npos && share.feature.empty() &&
                   share.fragments > 1000;
        };
        CHECK(std::ranges::any_of(shares, counts));
    }
    // What the units do not do is named.
    const std::string summary = comparison.summary();
    CHECK_THAT(summary, Contains("by the model: smooth primitives"));
    CHECK_THAT(summary, Contains("by the model: multisampling"));
    CHECK_THAT(summary, Contains("cube maps"));
}

TEST_CASE("Target bytes are compared after every draw") {
    RtlComparison comparison({.units = {"all"}});
    draw_on(comparison);
    CHECK(comparison.equal());
    CHECK_THAT(comparison.summary(),
               Contains("rtl: 40 draws, target bytes equal to the model's after each"));
}

TEST_CASE("A fault in any unit is told: the draw and the unit") {
    for (const UnitField& planted : Units) {
        INFO(planted.unit);
        const rtl::PlantedFault fault{planted.unit, planted.field, 50};
        RtlComparison comparison({.units = {planted.unit}, .fault = fault});
        draw_on(comparison);
        REQUIRE_FALSE(comparison.equal());
        const RtlDifference& difference = *comparison.difference();
        REQUIRE(difference.stage);
        CHECK(difference.stage->unit == planted.unit);
        CHECK(difference.stage->expected != difference.stage->got);
        CHECK_THAT(comparison.summary(),
                   Contains(fmt::format("rtl: draw {} is the first that parts", difference.draw)));
    }
}

// Of a unit that writes targets the pixel's place and both values are known beforehand.
TEST_CASE("A wrong pixel is told with its place and both values") {
    RtlComparison comparison(
        {.units = {"blend"}, .fault = rtl::PlantedFault{"blend", "pixels", 0}});
    test::Scene scene(8, 8, {.stages = &comparison.stages()});
    comparison.attach(scene.gpu, scene.gpu);
    comparison.number_draws_from(7);
    scene.into = &comparison;
    scene.clear(0);
    const auto corner = [](float x, float y) { return test::Vertex{x, y, 0, 1, 1, 1, 1, 1, 0, 0}; };
    // The right upper quarter, white.
    scene.draw(PrimitiveType::TriangleFan,
               {corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)});
    REQUIRE_FALSE(comparison.equal());
    const RtlDifference& difference = *comparison.difference();
    CHECK(difference.draw == 7);
    CHECK(difference.target.target == "colour target 0");
    CHECK(difference.target.x == 4);
    CHECK(difference.target.y == 4);
    CHECK(difference.target.expected == 0xffffffff);
    CHECK(difference.target.got == 0xfffffffe);
    // The picture goes on as the model's.
    CHECK(scene.pixel(4, 4) == 0xffffffff);
}

struct Told {
    int status;
    std::string text;
};

// Of two frames, a draw each.
Told replay_by(const std::string& units, std::vector<std::string> more = {}) {
    const TemporaryFile trace(trace::in_snappy(clears(2, true)));
    more.insert(more.begin(), {"replay", trace.path(), "--rtl", units});
    Told told{};
    told.text = printed(stderr, [&] { told.status = run(more); });
    return told;
}

TEST_CASE("replay --rtl draws a trace by units, and says what it compared") {
    const auto [status, text] = replay_by("tile_walker,blend");
    INFO(text);
    CHECK(status == 0);
    CHECK_THAT(text, Contains("rtl: 2 draws, target bytes equal"));
    CHECK_THAT(text, Contains("rtl: blend: 32 fragments, 100.00 %"));
    CHECK_THAT(text, !Contains("in frames before"));
}

TEST_CASE("replay --rtl says that it counts frames before the first of --frames as well") {
    const auto [status, text] = replay_by("blend", {"--frames", "1-1"});
    INFO(text);
    CHECK(status == 0);
    CHECK_THAT(
        text,
        Contains("\nrtl: of all that was drawn, in frames before 1 as well:\nrtl: blend: 32"));
    CHECK_THAT(text, Contains("rtl: 2 draws, target bytes equal"));
}

TEST_CASE("replay --rtl refuses names that are no unit's, and lists all") {
    const Told other = replay_by("bland");
    CHECK(other.status == 2);
    CHECK_THAT(other.text,
               Contains("there is no unit bland; there are all, tile_walker") &&
                   EndsWith(", blend, fragment_pipe\n"));
    const Told none = replay_by("");
    CHECK(none.status == 2);
    CHECK_THAT(none.text, Contains("--rtl: expected a value"));
}

TEST_CASE("replay --rtl UNIT refuses what fragment_pipe alone has") {
    const TemporaryFile cycles("older", ".csv");
    const Told with_cycles = replay_by("fog", {"--rtl-cycles", cycles.path()});
    CHECK(with_cycles.status == 2);
    CHECK(with_cycles.text == "ffgpu: --rtl-cycles: only fragment_pipe has cycles of draws\n");
    CHECK(content(cycles.path()) == "older");
    const Told with_latency = replay_by("fog", {"--rtl-latency", "5"});
    CHECK(with_latency.status == 2);
    CHECK(with_latency.text == "ffgpu: --rtl-latency: only fragment_pipe has a memory\n");
}

} // namespace
} // namespace ffgpu::tools
