// `ffgpu replay --swap`: what a trace's program finds in its back buffer after a swap.

#include "tests/support/temporary_file.h"
#include "tests/trace/trace_writer.h"
#include "tools/commands/command_line.h"
#include "tools/image/image.h"

#include <filesystem>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <unistd.h>

namespace ffgpu::tools {
namespace {

namespace fs = std::filesystem;
using Values = std::vector<std::function<void()>>;

constexpr unsigned Columns = 8;

// Frame i draws column i white over what is there, and clears nothing.
std::string trails(unsigned frames) {
    trace::TraceWriter writer;
    const auto integer = [&](std::int64_t value) { return [&, value] { writer.sint(value); }; };
    const auto real = [&](float value) { return [&, value] { writer.float32(value); }; };
    writer.call(1,
                "glXMakeCurrent",
                {"dpy", "drawable", "ctx"},
                Values{integer(0), integer(5), [&] { writer.pointer(0x1000); }});
    writer.call(2,
                "glViewport",
                {"x", "y", "width", "height"},
                Values{integer(0), integer(0), integer(Columns), integer(2)});
    for (unsigned i = 0; i < frames; ++i) {
        const float left = static_cast<float>(i) * 2 / Columns - 1;
        writer.call(3,
                    "glRectf",
                    {"x1", "y1", "x2", "y2"},
                    Values{real(left), real(-1), real(left + 2.0f / Columns), real(1)});
        writer.call(4, "glXSwapBuffers", {"dpy", "drawable"}, Values{integer(0), integer(5)});
    }
    return writer.bytes;
}

// The last frame's picture: '#' where a column is white.
std::string last_picture(const std::vector<std::string>& options) {
    constexpr unsigned Frames = 5;
    const TemporaryFile file(trace::in_snappy(trails(Frames)));
    const fs::path folder =
        fs::temp_directory_path() / ("ffgpu_swap_" + std::to_string(::getpid()));
    std::vector<std::string> words{"ffgpu", "replay", file.path(), "-o", folder.string()};
    words.insert(words.end(), options.begin(), options.end());
    std::vector<const char*> pointers;
    for (const std::string& word : words)
        pointers.push_back(word.c_str());
    REQUIRE(run_command_line(static_cast<int>(pointers.size()), pointers.data(), "test") == 0);
    const Image picture = read_image((folder / "frame_0004.png").string());
    fs::remove_all(folder);
    std::string seen;
    for (unsigned column = 0; column < Columns; ++column)
        seen += picture.rgb.at(std::size_t{3} * column) == 255 ? '#' : '.';
    return seen;
}

} // namespace

TEST_CASE("a trace's program may draw over its last frame") {
    CHECK(last_picture({}) == "#####...");
    CHECK(last_picture({"--swap", "copy"}) == "#####...");
    CHECK(last_picture({"--samples", "4"}) == "#####...");
    CHECK(last_picture({"--swap", "exchange"}) == "#.#.#...");
}

TEST_CASE("a swap mode that there is not is bad input") {
    const char* const words[] = {"ffgpu", "replay", "x.trace", "-o", "out", "--swap", "flip"};
    CHECK(run_command_line(7, words, "test") == 2);
}

} // namespace ffgpu::tools
