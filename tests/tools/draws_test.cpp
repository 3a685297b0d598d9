// Single draws: draws.csv, `--steps` and `--draws`.

#include "tests/support/temporary_file.h"
#include "tests/support/temporary_folder.h"
#include "tests/tools/scene_trace.h"
#include "tests/tools/tool.h"
#include "tools/image/image.h"

#include <filesystem>
#include <map>
#include <set>
#include <sstream>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

namespace ffgpu::tools {
namespace {

using Catch::Matchers::Contains;
namespace fs = std::filesystem;
using Line = std::map<std::string, std::string>; // by the column's name

std::vector<std::string> cut(const std::string& text) {
    std::vector<std::string> parts(1);
    for (const char character : text) {
        if (character == ',')
            parts.emplace_back();
        else
            parts.back() += character;
    }
    return parts;
}

std::vector<Line> lines_in(const std::string& path) {
    std::istringstream text(content(path));
    std::string line;
    std::getline(text, line);
    const std::vector<std::string> names = cut(line);
    std::vector<Line> lines;
    while (std::getline(text, line)) {
        const std::vector<std::string> values = cut(line);
        REQUIRE(values.size() == names.size());
        Line& entry = lines.emplace_back();
        for (std::size_t i = 0; i < names.size(); ++i)
            entry[names[i]] = values[i];
    }
    return lines;
}

struct TwoSquares {
    SceneTrace scene;
    std::uint64_t first_call = 0, second_call = 0;
    static constexpr int First = 10 * 10, Second = 6 * 6;

    TwoSquares() {
        scene.call("glClear", GlEnum{0x4000});
        scene.call("glColor3f", 1.0f, 0.0f, 0.0f);
        first_call = square(-16, 10);
        scene.call("glColor3f", 0.0f, 1.0f, 0.0f);
        scene.call("glShadeModel", GlEnum{0x1d00}); // What has another state is another draw.
        second_call = square(4, 6);
        scene.swap();
    }

private:
    std::uint64_t square(int from, int size) { // in pixels from the middle
        const auto begin = static_cast<float>(from) / 16;
        const auto end = static_cast<float>(from + size) / 16;
        return scene.call("glRectf", begin, begin, end, end);
    }
};

TEST_CASE("draws.csv has a line a draw, with the call that it came from and what it cost") {
    const TwoSquares squares;
    const TemporaryFolder folder;
    const TemporaryFile file(squares.scene.file());
    REQUIRE(run({"replay", file.path(), "-o", folder / "out", "--per-draw", "--timing"}) == 0);
    const std::vector<Line> lines = lines_in(folder / "out/draws.csv");
    const auto figures = nlohmann::json::parse(content(folder / "out/stats.json"))["frames"][0];
    std::vector<Line> draws;
    std::uint64_t cycles = 0;
    for (const Line& line : lines) {
        CHECK(line.at("frame") == "0");
        cycles += std::stoull(line.at("cycles"));
        if (line.at("kind") == "draw") draws.push_back(line);
    }
    REQUIRE(draws.size() == 2);
    CHECK(draws[0].at("call") == std::to_string(squares.first_call));
    CHECK(draws[1].at("call") == std::to_string(squares.second_call));
    CHECK(draws[0].at("function") == "glRectf");
    CHECK(draws[0].at("fragments_covered") == std::to_string(TwoSquares::First));
    CHECK(draws[1].at("fragments_written") == std::to_string(TwoSquares::Second));
    CHECK(draws[1].at("vertices") == "4");
    CHECK(draws[0].at("textures").empty());
    std::uint64_t listed = 0;
    for (const auto& command : figures["commands"])
        if (std::set<std::string>{"draw", "clear", "copy"}.contains(
                command["kind"].get<std::string>()))
            listed += command["cycles"].get<std::uint64_t>();
    CHECK(cycles == listed);
    CHECK(cycles > 0);
}

TEST_CASE("A command of which nobody looked what it waited for waits for none") {
    const TwoSquares squares;
    const TemporaryFolder folder;
    const TemporaryFile file(squares.scene.file());
    REQUIRE(run({"replay",
                 file.path(),
                 "-o",
                 folder / "out",
                 "--per-draw",
                 "--timing",
                 "--set",
                 "bottlenecks.enable=off"}) == 0);
    const std::vector<Line> lines = lines_in(folder / "out/draws.csv");
    CHECK(lines.size() >= 2);
    for (const Line& line : lines)
        CHECK(line.at("bottleneck") == "none");
    const auto frame = nlohmann::json::parse(content(folder / "out/stats.json"))["frames"][0];
    for (const auto& command : frame["commands"])
        CHECK(command["bottleneck"] == "none");
}

TEST_CASE("A draw's bytes by client stand in draws.csv and stats.json, and add up to the frame's") {
    const TwoSquares squares;
    const TemporaryFolder folder;
    const TemporaryFile file(squares.scene.file());
    REQUIRE(run({"replay", file.path(), "-o", folder / "out", "--per-draw", "--timing"}) == 0);
    const auto frame = nlohmann::json::parse(content(folder / "out/stats.json"))["frames"][0];
    std::map<std::string, std::uint64_t> sums, of_draws;
    for (const auto& command : frame["commands"])
        for (const auto& [name, value] : command.items())
            if (name.ends_with("_bytes")) {
                sums[name] += value.get<std::uint64_t>();
                if (command["kind"] == "draw") of_draws[name] += value.get<std::uint64_t>();
            }
    CHECK(sums.at("color_written_bytes") >= std::uint64_t{4} * (10 * 10 + 6 * 6));
    for (const auto& [name, sum] : sums)
        CHECK(frame["timing"]["memory_" + name] == sum);
    std::map<std::string, std::uint64_t> in_table;
    for (const Line& line : lines_in(folder / "out/draws.csv"))
        if (line.at("kind") == "draw")
            for (const auto& [name, value] : line)
                if (name.ends_with("_bytes") && value != "0") in_table[name] += std::stoull(value);
    CHECK(in_table == of_draws);
    CHECK(!of_draws.empty());
}

TEST_CASE("draws.csv counts the texels that a draw reads, and its misses with the timing model") {
    SceneTrace scene;
    scene.texture(Luminance, 4, std::string(16, 'x'), Nearest);
    scene.call("glTexParameteri", GlEnum{0x0de1}, GlEnum{0x2800}, Nearest); // magnified
    scene.call("glRectf", -0.5f, -0.5f, 0.5f, 0.5f);
    scene.swap();
    const TemporaryFolder folder;
    const TemporaryFile file(scene.file());
    REQUIRE(run({"replay", file.path(), "-o", folder / "out", "--per-draw", "--timing"}) == 0);
    std::vector<Line> lines = lines_in(folder / "out/draws.csv");
    std::erase_if(lines, [](const Line& line) { return line.at("kind") != "draw"; });
    REQUIRE(lines.size() == 1);
    CHECK(lines[0].at("textures") == "0:TwoD/luminance8/4x4/1");
    CHECK(lines[0].at("texel_accesses") == "256");
    CHECK(lines[0].at("texel_reads") == "256");
    CHECK(lines[0].at("texel_cache_misses") == "1"); // One texel, at (0, 0).

    REQUIRE(run({"replay", file.path(), "-o", folder / "plain", "--per-draw"}) == 0);
    CHECK(lines_in(folder / "plain/draws.csv").back().at("cycles").empty());
}

// Columns of the square are hidden by one that was drawn before at its depth. All fragments have
// coordinates (0, 0): of the 2x2 texels there three are of the border colour.
TEST_CASE("texels of hidden fragments and of the border colour are not read") {
    SceneTrace scene;
    scene.call("glClear", GlEnum{0x4100});
    scene.call("glEnable", GlEnum{0x0b71});             // depth test, less
    scene.call("glRectf", -0.5f, -0.5f, 0.0625f, 0.5f); // 9 columns of 16
    scene.texture(Luminance, 4, std::string(16, 'x'), Linear);
    scene.call("glTexParameteri", GlEnum{0x0de1}, GlEnum{0x2802}, GlEnum{0x2900}); // s: clamp
    scene.call("glTexParameteri", GlEnum{0x0de1}, GlEnum{0x2803}, GlEnum{0x2900}); // t
    scene.call("glRectf", -0.5f, -0.5f, 0.5f, 0.5f);
    scene.swap();
    const TemporaryFolder folder;
    const TemporaryFile file(scene.file());
    // Where values are kept hidden fragments are known with their texels.
    REQUIRE(run({"replay",
                 file.path(),
                 "-o",
                 folder / "out",
                 "--per-draw",
                 "--timing",
                 "--set",
                 "depth_blocks.compression=true"}) == 0);
    std::vector<Line> lines = lines_in(folder / "out/draws.csv");
    std::erase_if(lines, [](const Line& line) { return line.at("kind") != "draw"; });
    REQUIRE(lines.size() == 2);
    CHECK(lines[1].at("fragments_killed_early_depth") == "144");
    CHECK(lines[1].at("texel_accesses") == "112");
    CHECK(lines[1].at("texel_reads") == "112");
    const auto figures = nlohmann::json::parse(content(folder / "out/stats.json"))["totals"];
    CHECK(figures["timing"]["texture_texel_reads"] == 112);
    for (const auto& [name, value] : lines[0]) {
        if (!name.starts_with("fragments_")) continue;
        INFO(name);
        CHECK(figures["functional"].at(name) ==
              std::stoull(value) + std::stoull(lines[1].at(name)));
    }
}

std::size_t count_of_pictures(const std::string& folder) {
    std::size_t count = 0;
    for (const auto& entry : fs::directory_iterator(folder))
        count += entry.path().extension() == ".png";
    return count;
}

std::size_t pixels_of(const std::string& path, std::size_t channel) {
    const Image image = read_image(path);
    std::size_t count = 0;
    for (std::size_t i = 0; i < image.pixels(); ++i)
        count += image.rgb[3 * i + channel] == 255;
    return count;
}

TEST_CASE("--steps writes the frame as it is behind each n-th draw") {
    const TwoSquares squares;
    const TemporaryFolder folder;
    const TemporaryFile file(squares.scene.file());
    REQUIRE(run({"replay", file.path(), "-o", folder / "one", "--steps", "1"}) == 0);
    CHECK(count_of_pictures(folder / "one") == 3);
    const std::string first = folder / "one/frame_0000_draw_0000.png";
    CHECK(pixels_of(first, 0) == TwoSquares::First);
    CHECK(pixels_of(first, 1) == 0);
    CHECK(content(folder / "one/frame_0000_draw_0001.png") ==
          content(folder / "one/frame_0000.png"));
    REQUIRE(run({"replay", file.path(), "-o", folder / "two", "--steps", "2"}) == 0);
    CHECK(count_of_pictures(folder / "two") == 2);
    CHECK(fs::exists(folder / "two/frame_0000_draw_0001.png"));
}

TEST_CASE("--draws leaves the others out, and their numbers as they are") {
    const TwoSquares squares;
    const TemporaryFolder folder;
    const TemporaryFile file(squares.scene.file());
    const auto replay = [&](const std::string& draws) {
        REQUIRE(run({"replay", file.path(), "-o", folder / draws, "--draws", draws}) == 0);
        const std::string frame = folder / draws + "/frame_0000.png";
        return std::pair(pixels_of(frame, 0), pixels_of(frame, 1));
    };
    CHECK(replay("0") == std::pair(std::size_t{TwoSquares::First}, std::size_t{0}));
    CHECK(replay("1-") == std::pair(std::size_t{0}, std::size_t{TwoSquares::Second}));
    CHECK(replay("0-1") ==
          std::pair(std::size_t{TwoSquares::First}, std::size_t{TwoSquares::Second}));
    CHECK(replay("2-") == std::pair(std::size_t{0}, std::size_t{0}));
    CHECK(run({"replay", file.path(), "-o", folder / "x", "--draws", "1-0"}) == 2);
    const auto told = [&](const std::string& option, const std::string& value) {
        return printed(stderr, [&] {
            run({"replay", file.path(), "-o", folder / "x", option, value});
        });
    };
    CHECK_THAT(told("--draws", "2-"),
               Contains("the draws are 0 to 1: none of those wanted is there"));
    CHECK_THAT(told("--draws", "1-2"), Contains("the last draw is 1\n"));
    CHECK_THAT(told("--draws", "0-1"), !Contains("last draw"));
    CHECK_THAT(told("--draws", "1-"), !Contains("last draw"));
    const std::string four_a_frame = FFGPU_SOURCE_DIR "/traces/corridor.trace";
    CHECK_THAT(printed(stderr,
                       [&] {
                           run({"replay",
                                four_a_frame,
                                "--no-images",
                                "-o",
                                folder / "y",
                                "--frames",
                                "1",
                                "--draws",
                                "0-3"});
                       }),
               Contains("the draws are 4 to 7: none of those wanted is there"));
    CHECK_THAT(told("--steps", "3"), Contains("no frame has more than 2 draws"));
    CHECK_THAT(told("--steps", "2"), !Contains("no frame"));
}

} // namespace
} // namespace ffgpu::tools
