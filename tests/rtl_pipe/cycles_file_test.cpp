// The file of `--rtl-cycles`: there whole, with what was drawn up to an error, or not at all.

#include "model/base/input_error.h"
#include "tests/gpu/scene.h"
#include "tests/support/file_size_limit.h"
#include "tests/support/temporary_file.h"
#include "tests/tools/tool.h"
#include "tools/rtl/pipe_comparison.h"

#include <algorithm>

#include <catch2/catch.hpp>

namespace ffgpu::tools {
namespace {

using Catch::Contains;
using Catch::StartsWith;

struct Told {
    int status;
    std::string text;
};

Told replay_with_cycles(const std::string& input,
                        const std::string& cycles,
                        const std::string& frames = "0-") {
    Told told{};
    told.text = printed(stderr, [&] {
        told.status = run({"replay",
                           input,
                           "--rtl",
                           "fragment_pipe",
                           "--rtl-cycles",
                           cycles,
                           "--frames",
                           frames});
    });
    return told;
}

// A line of names and one for each of two draws.
void check_lines(const std::string& text) {
    CHECK_THAT(text,
               StartsWith("draw,cycles,raster_busy,raster_stalled,") && Contains("\n0,") &&
                   Contains("\n1,"));
    CHECK(std::count(text.begin(), text.end(), '\n') == 3);
}

TEST_CASE("Cycles of the pipe are a line a draw") {
    const TemporaryFile trace(trace::in_snappy(clears(2, true))), cycles("older", ".csv");
    const auto [status, text] = replay_with_cycles(trace.path(), cycles.path());
    INFO(text);
    CHECK(status == 0);
    check_lines(content(cycles.path()));
}

TEST_CASE("Cycles that find no room are an error, told in one line") {
    const TemporaryFile trace(trace::in_snappy(clears(2, true)));
    const auto [status, text] = replay_with_cycles(trace.path(), "/dev/full");
    CHECK(status == 2);
    CHECK(text == "ffgpu: /dev/full: cannot be written: No space left on device\n");
}

TEST_CASE("Cycles that find no room behind a draw are told by the file's name alone") {
    const TemporaryFile cycles("older", ".csv");
    PipeComparison comparison({.jitters = false}, cycles.path());
    test::Scene scene(8, 8);
    comparison.attach(scene.gpu, scene.gpu);
    scene.into = &comparison;
    const FileSizeLimit limit(200); // The names are 188 bytes.
    const auto draw = [&] {
        scene.draw(PrimitiveType::Triangles,
                   {{-1, -1, 0, 1, 1, 1, 1, 1, 0, 0},
                    {3, -1, 0, 1, 1, 1, 1, 1, 0, 0},
                    {-1, 3, 0, 1, 1, 1, 1, 1, 0, 0}});
    };
    CHECK_THROWS_WITH(draw(), cycles.path() + ": cannot be written: File too large");
    CHECK_THROWS_AS(comparison.commit(), OutputError);
    CHECK(content(cycles.path()) == "older");
}

TEST_CASE("Cycles of what was drawn before an error are kept") {
    const TemporaryFile trace(trace::in_snappy(clears(2, true))), cycles("older", ".csv");
    CHECK(replay_with_cycles(trace.path(), cycles.path(), "7-").status == 2);
    check_lines(content(cycles.path()));
}

TEST_CASE("Cycles of an older run stay where an input cannot be read") {
    const TemporaryFile cycles("older", ".csv");
    CHECK(replay_with_cycles("there is none", cycles.path()).status == 2);
    CHECK(content(cycles.path()) == "older");
}

} // namespace
} // namespace ffgpu::tools
