// gpu.texture_filter and gpu.supersampling through the verbs: the picture is that of the same
// machine however it is reached, and the machine in time counts what it costs.

#include "tests/support/temporary_folder.h"
#include "tests/system/trace_run.h"
#include "tests/tools/tool.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

namespace ffgpu::tools {
namespace {

using Catch::Contains;
using Json = nlohmann::json;

const std::string Corridor = own_trace("corridor");
constexpr const char* Frames = "1-1";

Json stats(const std::string& folder) {
    return Json::parse(content(folder + "/stats.json"))["totals"];
}

std::vector<std::string>
replay_of(const std::string& input, const std::string& folder, std::vector<std::string> more) {
    std::vector<std::string> arguments{"replay", input, "-o", folder};
    if (input == Corridor) arguments.insert(arguments.end(), {"--frames", Frames});
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

TEST_CASE("A forced filter is drawn, captured, timed, explained and counted in caches alike") {
    const TemporaryFolder folder;
    const std::string set = "gpu.texture_filter=feline";
    REQUIRE(run(replay_of(Corridor, folder / "plain", {"--timing"})) == 0);
    REQUIRE(run(replay_of(Corridor,
                          folder / "feline",
                          {"--timing",
                           "--set",
                           set,
                           "--capture",
                           folder / "feline.ffc",
                           "--save-work",
                           folder / "feline.ffw"})) == 0);
    CHECK(run({"compare", folder / "plain", folder / "feline"}) == 1);
    const Json plain = stats(folder / "plain"), feline = stats(folder / "feline");
    CHECK(feline["functional"]["fragments_written"] == plain["functional"]["fragments_written"]);
    CHECK(feline["timing"]["texture_texel_reads"] > plain["timing"]["texture_texel_reads"]);
    CHECK(feline["timing"]["total_cycles"] > plain["timing"]["total_cycles"]);

    REQUIRE(run(replay_of(Corridor, folder / "scalar", {"--reference", "--set", set})) == 0);
    CHECK(run({"compare", folder / "feline", folder / "scalar"}) == 0);
    REQUIRE(run(replay_of(folder / "feline.ffc", folder / "again", {"--timing"})) == 0);
    CHECK(run({"compare", folder / "feline", folder / "again"}) == 0);
    CHECK(stats(folder / "again")["timing"] == feline["timing"]);
    REQUIRE(run({"time", folder / "feline.ffw", "-o", folder / "timed"}) == 0);
    CHECK(stats(folder / "timed")["timing"] == feline["timing"]);

    // A cache of the machine's shape sees as many look-ups and misses from the trace.
    const auto texel_rows = [&](const std::string& input, const std::vector<std::string>& more) {
        std::vector<std::string> arguments{"cache", input, "--client", "texel"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const std::string text = printed(stdout, [&] { CHECK(run(arguments) == 0); });
        return text.substr(text.find('\n')); // behind the input's name
    };
    CHECK(texel_rows(Corridor, {"--frames", Frames, "--set", set}) ==
          texel_rows(folder / "feline.ffw", {}));
    const auto exported = [&](const std::string& input, const std::vector<std::string>& more) {
        std::vector<std::string> arguments{
            "export", input, "--format", "din", "-o", folder / "trace.din"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        CHECK(run(arguments) == 0);
        return content(folder / "trace.din");
    };
    CHECK(exported(Corridor, {"--frames", Frames, "--set", set}) ==
          exported(folder / "feline.ffw", {}));
}

TEST_CASE("Supersampling draws each fragment as often as there are samples, and all verbs know") {
    const TemporaryFolder folder;
    const std::string set = "gpu.supersampling=4";
    REQUIRE(run(replay_of(Corridor, folder / "plain", {"--timing"})) == 0);
    REQUIRE(run(replay_of(Corridor,
                          folder / "smooth",
                          {"--timing", "--set", set, "--capture", folder / "smooth.ffc"})) == 0);
    CHECK(run({"compare", folder / "plain", folder / "smooth"}) == 1);
    const Json plain = stats(folder / "plain"), smooth = stats(folder / "smooth");
    const auto times = [&](const char* group, const char* name) {
        return smooth[group][name].get<double>() / plain[group][name].get<double>();
    };
    CHECK(times("functional", "fragments_covered") == Approx(4).epsilon(0.002));
    CHECK(times("functional", "vertices_shaded") == Approx(4).epsilon(0.002));
    CHECK(times("timing", "texture_texel_reads") == Approx(4).epsilon(0.01));
    CHECK(times("timing", "total_cycles") > 3);
    REQUIRE(run(replay_of(Corridor, folder / "scalar", {"--reference", "--set", set})) == 0);
    CHECK(run({"compare", folder / "smooth", folder / "scalar"}) == 0);
    REQUIRE(run(replay_of(folder / "smooth.ffc", folder / "again", {"--timing"})) == 0);
    CHECK(run({"compare", folder / "smooth", folder / "again"}) == 0);
    CHECK(stats(folder / "again")["timing"] == smooth["timing"]);
    REQUIRE(run(replay_of(Corridor,
                          folder / "tiled",
                          {"--timing", "--set", set, "raster.architecture=tile_based"})) == 0);
    CHECK(run({"compare", folder / "smooth", folder / "tiled"}) == 0);
}

TEST_CASE("What no driver draws any more cannot be forced, and is told of") {
    const TemporaryFolder folder;
    REQUIRE(run(replay_of(Corridor,
                          folder / "out",
                          {"--capture", folder / "c.ffc", "--save-work", folder / "w.ffw"})) == 0);
    const auto says = [&](const std::vector<std::string>& arguments, int status) {
        return printed(stderr, [&] { CHECK(run(arguments) == status); });
    };
    for (const std::string set : {"gpu.texture_filter=elliptic", "gpu.supersampling=2"}) {
        INFO(set);
        CHECK_THAT(says({"replay", folder / "c.ffc", "-o", folder / "no", "--set", set}, 2),
                   Contains("is a capture, which no driver draws"));
        CHECK_THAT(says({"time", folder / "w.ffw", "-o", folder / "t", "--set", set}, 0),
                   Contains("is work that was drawn"));
    }
    CHECK_THAT(
        says(replay_of(Corridor, folder / "no", {"--samples", "4", "--set", "gpu.supersampling=4"}),
             2),
        Contains("a window has one or the other"));
    CHECK_THAT(says(replay_of(Corridor, folder / "no", {"--set", "gpu.supersampling=3"}), 2),
               Contains("expected 1 to 16, a power of two, found 3"));
    CHECK_THAT(says(replay_of(Corridor, folder / "no", {"--set", "gpu.texture_filter=best"}), 2),
               Contains("\"as_asked\", \"standard\", \"bicubic\""));
}

} // namespace
} // namespace ffgpu::tools
