// `ffgpu replay`: what it says about a trace, and captures that stand for a part of one.

#include "tests/support/temporary_file.h"
#include "tests/support/temporary_folder.h"
#include "tests/tools/tool.h"

#include <filesystem>

#include <catch2/catch.hpp>
#include <fcntl.h>

namespace ffgpu::tools {
namespace {

using Catch::Matchers::Contains;

// Without the one thing that a capture does not know.
std::string without_api_calls(const std::string& path) {
    std::istringstream lines(content(path));
    std::string text;
    for (std::string line; std::getline(lines, line);)
        if (line.find("\"api_calls\"") == std::string::npos) text += line + '\n';
    return text;
}

TEST_CASE("A capture's figures equal those of the run that it was made from") {
    const TemporaryFolder folder;
    const TemporaryFile trace(trace::in_snappy(clears(5, true)));
    REQUIRE(run({"replay",
                 trace.path(),
                 "-o",
                 folder / "live",
                 "--frames",
                 "2-",
                 "--timing",
                 "--save-work",
                 folder / "live.ffw",
                 "--capture",
                 folder / "live.ffc"}) == 0);
    for (const char* const again : {"first", "second"}) {
        const std::string from =
            folder / (std::string(again) == "first" ? "live.ffc" : "first.ffc");
        REQUIRE(run({"replay",
                     from,
                     "-o",
                     folder / again,
                     "--timing",
                     "--save-work",
                     folder / (again + std::string(".ffw")),
                     "--capture",
                     folder / (again + std::string(".ffc"))}) == 0);
        const std::string figures = without_api_calls(folder / again + "/stats.json");
        CHECK_THAT(figures, Contains("\"draw\": 2,")); // Two came before the capture's first.
        CHECK(figures == without_api_calls(folder / "live/stats.json"));
        CHECK(content(folder / (again + std::string(".ffc"))) == content(folder / "live.ffc"));
    }
    CHECK(run({"compare", folder / "live", folder / "second"}) == 0);
    // The work files differ in the calls of the API alone, which time does not see.
    REQUIRE(run({"time", folder / "first.ffw", "-o", folder / "timed"}) == 0);
    CHECK(content(folder / "timed/stats.json") == content(folder / "first/stats.json"));
}

std::string warnings_of(const std::vector<std::string>& arguments) {
    return printed(stderr, [&] { CHECK(run(arguments) == 0); });
}

TEST_CASE("A setting that decides nothing without the timing model is told of") {
    const TemporaryFolder folder;
    const TemporaryFile trace(trace::in_snappy(clears(1)));
    const auto set = [&](std::vector<std::string> settings, bool timing = false) {
        std::vector<std::string> arguments{"replay", trace.path(), "-o", folder / "out"};
        for (const std::string& setting : settings)
            arguments.insert(arguments.end(), {"--set", setting});
        if (timing) arguments.emplace_back("--timing");
        return warnings_of(arguments);
    };
    const std::string line = set({"texel_cache.ways=2", "gpu.threads=1", " raster.tile_width = 8"});
    CHECK_THAT(line,
               Contains("ffgpu: warning: --set texel_cache.ways=2,  raster.tile_width = 8: has no "
                        "effect without --timing\n"));
    CHECK_THAT(set({"gpu.threads=1"}), !Contains("warning"));
    CHECK_THAT(set({" gpu.threads=1"}), !Contains("warning"));
    CHECK_THAT(set({"texel_cache.ways=2"}, true), !Contains("warning"));
}

TEST_CASE("A trace that draws, but in no context, is told of with the way to record EGL") {
    const TemporaryFolder folder;
    const auto warnings = [&](const trace::TraceWriter& writer) {
        const TemporaryFile trace(trace::in_snappy(writer.bytes));
        return warnings_of({"replay", trace.path(), "-o", folder / "out"});
    };
    trace::TraceWriter drawing;
    drawing.call(0, "glEnable", {"cap"}, {[&] { drawing.enumeration(0, 0x0b71); }});
    drawing.call(1, "glBegin", {"mode"}, {[&] { drawing.enumeration(0, 4); }});
    drawing.call(2, "glEnd", {}, {});
    CHECK_THAT(warnings(drawing),
               Contains("call 1 glBegin draws, but no call makes a context current") &&
                   Contains("apitrace trace -a egl"));
    const trace::TraceWriter empty;
    CHECK_THAT(warnings(empty), Contains("holds no calls") && Contains("apitrace trace -a egl"));

    trace::TraceWriter asking;
    asking.call(0, "glGetError", {}, {});
    CHECK_THAT(warnings(asking), !Contains("warning"));
    const TemporaryFile good(trace::in_snappy(clears(1, true)));
    CHECK_THAT(warnings_of({"replay", good.path(), "-o", folder / "out"}), !Contains("warning"));
}

TEST_CASE("The player alone is timed where nothing is drawn, and nowhere else") {
    const TemporaryFolder folder;
    const TemporaryFile trace(trace::in_snappy(clears(3, true)));
    const std::string line =
        warnings_of({"replay", trace.path(), "--benchmark", "2", "--player-only"});
    CHECK_THAT(line, Contains("frames/s over 3 frames"));
    CHECK_THAT(line, Contains("over the last frame, 2 times"));
    CHECK_THAT(line, Contains("0 draws"));
    const std::vector<std::vector<std::string>> refused{
        {"replay", trace.path(), "--player-only", "-o", folder / "out"},
        {"replay", trace.path(), "--player-only", "--benchmark", "2", "-o", folder / "out"},
        {"replay",
         trace.path(),
         "--player-only",
         "--benchmark",
         "2",
         "--capture",
         folder / "a.ffc"},
    };
    for (const std::vector<std::string>& arguments : refused) {
        int status = 0;
        const std::string told = printed(stderr, [&] { status = run(arguments); });
        CHECK(status == 2);
        CHECK_THAT(told, Contains("--player-only draws nothing"));
    }
}

TEST_CASE("Pictures of an older run are told of") {
    const TemporaryFolder folder;
    const TemporaryFile trace(trace::in_snappy(clears(4)));
    const auto replay = [&](const std::string& frames) {
        return warnings_of({"replay", trace.path(), "-o", folder / "out", "--frames", frames});
    };
    CHECK_THAT(replay("0-3"), !Contains("warning"));
    CHECK_THAT(replay("0-3"), !Contains("warning"));
    CHECK_THAT(replay("1-2"),
               Contains("out: holds 2 pictures of an older run, too, frame_0000.png to "
                        "frame_0003.png"));
    const TemporaryFile damaged("Some text.\n");
    CHECK(run({"replay", damaged.path(), "-o", folder / "out"}) == 2);
    CHECK(!content(folder / "out/stats.json").empty()); // Nothing was written over it.
}

TEST_CASE("A capture or work file without a frame is not kept") {
    const TemporaryFolder folder;
    const TemporaryFile trace(trace::in_snappy(clears(2)));
    for (const std::string frames : {"2-3", "7-8"})
        for (const std::string option : {"--capture", "--save-work"}) {
            const std::string file = folder / "kept";
            int status = 0;
            const std::string told = printed(stderr, [&] {
                status = run({"replay", trace.path(), "--frames", frames, option, file});
            });
            CAPTURE(frames, option, told);
            CHECK(status == 2);
            CHECK_FALSE(std::filesystem::exists(file));
        }
}

TEST_CASE("A capture that cannot be begun has that reason alone") {
    const TemporaryFolder folder;
    const TemporaryFile trace(trace::in_snappy(clears(1)));
    const std::string told = printed(stderr, [&] {
        CHECK(run({"replay", trace.path(), "--capture", folder / "none/c.ffc"}) == 2);
    });
    CHECK_THAT(told, Contains("none/c.ffc: cannot be written") && !Contains("there is no frame"));
}

TEST_CASE("No folder holds an input under a name that is written there") {
    const TemporaryFolder folder;
    const TemporaryFile trace(trace::in_snappy(clears(2)));
    const std::string work = folder / "stats.json", drawn = folder / "frame_0000.png";
    REQUIRE(run({"replay", trace.path(), "--save-work", work}) == 0);
    std::filesystem::copy_file(trace.path(), drawn);
    const std::string held = content(work);
    const auto status = [&](std::vector<std::string> command) {
        command.insert(command.end(), {"-o", folder / "none/.."});
        int ended = 0;
        const std::string told = printed(stderr, [&] { ended = run(command); });
        if (ended != 0) CHECK_THAT(told, Contains("holds the input"));
        return ended;
    };
    CHECK(status({"time", work}) == 2);
    CHECK(status({"cache", work}) == 2);
    CHECK(status({"replay", drawn}) == 2);
    CHECK((content(work) == held));
    CHECK((content(drawn) == content(trace.path())));
    const std::string other = folder / "work.ffw";
    std::filesystem::rename(work, other);
    CHECK(status({"time", other}) == 0);
}

TEST_CASE("No folder holds a link to an input under a name that is written there") {
    const TemporaryFolder folder;
    const TemporaryFile trace(trace::in_snappy(clears(2)));
    const std::string work = folder / "work.ffw";
    REQUIRE(run({"replay", trace.path(), "--save-work", work}) == 0);
    const std::string held = content(work);
    std::filesystem::create_directory(folder / "out");
    std::filesystem::create_symlink(work, folder / "out/stats.json");
    const std::string told = printed(stderr, [&] {
        CHECK(run({"time", work, "-o", folder / "out"}) == 2);
    });
    CHECK_THAT(told, Contains("holds the input"));
    CHECK((content(work) == held));
}

TEST_CASE("A configuration that is read is not written over") {
    const TemporaryFolder folder;
    const TemporaryFile trace(trace::in_snappy(clears(2)));
    const std::string config = folder / "machine.toml", work = folder / "work.ffw";
    REQUIRE(run({"replay", trace.path(), "--save-work", work}) == 0);
    constexpr const char* Text = "[texel_cache]\nways = 2\n";
    std::ofstream(config) << Text;
    const std::vector<std::vector<std::string>> commands{
        {"export", work, "--format", "din", "-o", config},
        {"time", work, "--totals", config},
        {"replay", trace.path(), "--capture", config},
        {"replay", trace.path(), "--rtl", "fragment_pipe", "--rtl-cycles", config},
        {"explain", trace.path(), "--frame", "0", "--pixel", "1,1", "-o", config}};
    for (std::vector<std::string> command : commands) {
        CAPTURE(command);
        command.insert(command.end(), {"--config", config});
        const std::string told = printed(stderr, [&] { CHECK(run(command) == 2); });
        CHECK_THAT(told, Contains("is the input, which would be written over"));
        CHECK(content(config) == Text);
    }
}

TEST_CASE("A range of frames is one, and whose end is not there is told of") {
    const TemporaryFolder folder;
    const TemporaryFile trace(trace::in_snappy(clears(3)));
    const std::vector<std::vector<std::string>> commands{
        {"replay", trace.path(), "-o", folder / "out"},
        {"cache", trace.path()},
        {"export", trace.path(), "--format", "din", "-o", folder / "out.din"},
        {"report", folder / "out"}};
    for (const std::vector<std::string>& command : commands) {
        CAPTURE(command);
        const auto with = [&](const char* frames, int status) {
            std::vector<std::string> words = command;
            words.insert(words.end(), {"--frames", frames});
            std::string printed_out;
            std::string told = printed(stderr, [&] {
                printed_out = printed(stdout, [&] { CHECK(run(words) == status); });
            });
            return told + printed_out;
        };
        CHECK_THAT(with("", 2), Contains("expected A-B"));
        CHECK_THAT(with("3", 2), Contains("none of"));
        CHECK_THAT(with("1-5", 0), Contains("ends before frame 3, 5 was asked for"));
        CHECK_THAT(with("1-2", 0), !Contains("ends before"));
    }
    CHECK(run({"replay", trace.path(), "-o", folder / "out", "--draws", ""}) == 2);
}

TEST_CASE("A capture's frames before its first are none") {
    const TemporaryFolder folder;
    const TemporaryFile trace(trace::in_snappy(clears(4)));
    const std::string capture = folder / "c.ffc";
    REQUIRE(run({"replay", trace.path(), "--frames", "2-3", "--capture", capture}) == 0);
    const std::string told = printed(stderr, [&] {
        CHECK(run({"cache", capture, "--frames", "0-1"}) == 2);
    });
    CHECK_THAT(told, Contains("begins with frame 2"));
}

TEST_CASE("Options that a format of an export has not are told of") {
    const TemporaryFile trace(trace::in_snappy(clears(2)));
    const auto told = [&](const char* format) {
        return warnings_of({"export",
                            trace.path(),
                            "--format",
                            format,
                            "-o",
                            "/dev/null",
                            "--client",
                            "color",
                            "--access-bytes",
                            "32"});
    };
    const auto client = Contains("--client: has no effect with --format");
    const auto bytes = Contains("--access-bytes: has no effect with --format");
    CHECK_THAT(told("din"), !client && bytes);
    CHECK_THAT(told("dramsim3"), client && !bytes);
    CHECK_THAT(told("csv"), client && bytes);
}

TEST_CASE("Charts and maps of older curves are told of") {
    const TemporaryFolder folder;
    const TemporaryFile trace(trace::in_snappy(clears(3, true)));
    const auto cache = [&](const char* lines) {
        return warnings_of({"cache",
                            trace.path(),
                            "--client",
                            "color",
                            "--line",
                            lines,
                            "--miss-map",
                            "4x1x64",
                            "-o",
                            folder / "out"});
    };
    CHECK_THAT(cache("32,64"), !Contains("older"));
    CHECK_THAT(cache("32,64"), !Contains("older"));
    CHECK_THAT(cache("64"), Contains("holds a picture of an older run, too, misses_color"));
    std::ofstream(folder / "out/frame_0000.png") << "of another verb";
    std::ofstream(folder / "out/miss_map_0007.png") << "of a longer trace";
    CHECK_THAT(cache("32,64"), Contains("holds a picture of an older run, too, miss_map_0007.png"));
}

TEST_CASE("No output takes the place of the input") {
    const TemporaryFolder folder;
    const TemporaryFile trace(trace::in_snappy(clears(2)));
    const std::string link = folder / "link", work = folder / "work.ffw";
    std::filesystem::create_symlink(trace.path(), link);
    REQUIRE(run({"replay", trace.path(), "--save-work", work}) == 0);
    const auto refused = [](const std::vector<std::string>& command) {
        int status = 0;
        const std::string told = printed(stderr, [&] { status = run(command); });
        CAPTURE(command);
        CHECK(status == 2);
        CHECK_THAT(told, Contains("is the input, which would be written over"));
    };
    for (const std::string& output : {trace.path(), link}) {
        refused({"replay", trace.path(), "--save-work", output});
        refused({"replay", trace.path(), "--capture", output});
        refused({"export", trace.path(), "--format", "csv", "-o", output});
        refused({"export", trace.path(), "--format", "fst", "-o", output});
        refused({"explain", trace.path(), "--frame", "0", "--pixel", "1,1", "-o", output});
    }
    refused({"time", work, "--totals", folder / "none/../work.ffw"});
    CHECK(run({"time", work, "--totals", folder / "totals.json"}) == 0);
    CHECK(run({"replay", trace.path(), "--save-work", folder / "again.ffw"}) == 0);
}

TEST_CASE("Two files of one name are refused, and nothing is written") {
    const TemporaryFolder folder;
    const TemporaryFile trace(trace::in_snappy(clears(2)));
    const auto refused = [&](const std::string& option, std::vector<std::string> more) {
        more.insert(more.begin(), {"replay", trace.path(), "--capture", folder / "kept"});
        more.insert(more.end(), {option, folder / "none/../kept"});
        int status = 0;
        const std::string told = printed(stderr, [&] { status = run(more); });
        CHECK(status == 2);
        CHECK_THAT(told, Contains("is both --capture's and " + option + "'s file"));
        CHECK(std::filesystem::is_empty(folder.path()));
    };
    refused("--save-work", {});
    refused("--rtl-cycles", {"--rtl", "fragment_pipe"});
}

TEST_CASE("What is printed where no room is ends with status 2") {
    std::fflush(stdout);
    const int kept = ::dup(::fileno(stdout));
    const int full = ::open("/dev/full", O_WRONLY);
    ::dup2(full, ::fileno(stdout));
    const std::string line = printed(stderr, [] { CHECK(run({"config"}) == 2); });
    std::clearerr(stdout);
    ::dup2(kept, ::fileno(stdout));
    ::close(kept);
    ::close(full);
    CHECK_THAT(line, Contains("standard output: cannot be written"));
}

} // namespace
} // namespace ffgpu::tools
