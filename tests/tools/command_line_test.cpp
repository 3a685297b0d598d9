// The command line as its users meet it, in this process.

#include "model/base/input_error.h"
#include "model/capture/capture_writer.h"
#include "model/gpu/functional_gpu.h"
#include "tests/support/temporary_file.h"
#include "tests/support/temporary_folder.h"
#include "tests/tools/tool.h"
#include "tools/config/config_file.h"
#include "tools/config/settings_option.h"
#include "tools/frames/frame_range.h"
#include "tools/image/compare_images.h"
#include "tools/replay/replay.h"

#include <cmath>
#include <filesystem>

#include <catch2/catch.hpp>

namespace ffgpu::tools {
namespace {

using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;
namespace fs = std::filesystem;

std::string capture_without_frames() {
    const TemporaryFile file("", ".ffc");
    FunctionalGpu gpu({.memory_bytes = 1 << 20});
    capture::CaptureWriter writer(gpu);
    writer.begin(file.path(), 5);
    writer.end();
    return content(file.path());
}

TEST_CASE("Each bad input is one clear line and exit status 2") {
    const TemporaryFolder folder;
    const auto replay_error = [&](const std::string& bytes) -> std::string {
        const TemporaryFile file(bytes);
        ReplayOptions options;
        options.input = file.path();
        options.output = folder / "out";
        CHECK(run({"replay", file.path(), "-o", folder / "out"}) == 2);
        try {
            replay(options);
        } catch (const InputError& error) {
            std::string text = error.what();
            CHECK(text.find('\n') == std::string::npos);
            CHECK_THAT(text, Contains(file.path()));
            return text;
        }
        return "no error";
    };
    CHECK(run({"replay", folder / "missing.trace", "-o", folder / "out"}) == 2);
    CHECK_THAT(replay_error(""), Contains("byte 0: is empty"));
    CHECK_THAT(replay_error(capture_without_frames()), Contains("expected a frame"));
    CHECK_THAT(replay_error("Some text.\n"), Contains("not a trace"));
    CHECK_THAT(replay_error(trace::in_snappy(trace::TraceWriter(7).bytes)), Contains("version 7"));
    const std::string whole = clears(3);
    CHECK_THAT(replay_error(trace::in_snappy(whole.substr(0, whole.size() - 3))),
               Contains("glXSwapBuffers"));
    std::string wild = whole; // glClear with a blob of 2^63 bytes.
    wild.append("\0\0\4\1\0\x8\xff\xff\xff\xff\xff\xff\xff\xff\x7f", 15);
    CHECK_THAT(replay_error(trace::in_snappy(wild)), Contains("blob's length"));

    CHECK(run({}) == 2);
    CHECK(run({"fly"}) == 2);
    CHECK(run({"replay"}) == 2);
    CHECK(run({"config", "--set", "texel_cache.wayz=8"}) == 2);
    CHECK(run({"compare", "/nonexistent", "/nonexistent"}) == 2);
}

TEST_CASE("A folder where a text is expected is one line") {
    const TemporaryFolder folder;
    const TemporaryFile file(trace::in_snappy(clears(1)));
    const auto said = [](const std::vector<std::string>& words) {
        return printed(stderr, [&] { CHECK(run(words) == 2); });
    };
    const std::string line = "ffgpu: " + folder.path() + ": cannot be read\n";
    CHECK(said({"config", "--config", folder.path()}) == line);
    CHECK(said({"replay", file.path(), "-o", folder / "out", "--config", folder.path()}) == line);
    CHECK(said({"check", folder.path(), "-o", folder / "out"}) == line);
}

TEST_CASE("What the system says of a folder is one line") {
    const TemporaryFolder folder;
    std::filesystem::create_symlink("loop", folder / "loop");
    std::filesystem::create_directory(folder / "pictures");
    const std::string said = printed(stderr, [&] {
        CHECK(run({"compare", folder / "pictures", folder / "loop"}) == 2);
    });
    CHECK_THAT(said, Contains(folder / "loop"));
    CHECK(std::count(said.begin(), said.end(), '\n') == 1);
}

TEST_CASE("A report of a folder whose name is no UTF-8 is a page") {
    const TemporaryFolder folder;
    const TemporaryFile file(trace::in_snappy(clears(1)));
    const std::string out = folder / "o\xFF";
    REQUIRE(run({"replay", file.path(), "-o", out}) == 0);
    REQUIRE(run({"report", out}) == 0);
    CHECK_THAT(content(out + "/report.html"), Contains("o\xEF\xBF\xBD"));
}

TEST_CASE("Frames before a damaged place are written, and so are their statistics") {
    const TemporaryFolder folder;
    const std::string whole = clears(3);
    const TemporaryFile file(trace::in_snappy(whole.substr(0, whole.size() - 3)));
    CHECK(run({"replay", file.path(), "-o", folder / "out"}) == 2);
    CHECK(fs::exists(folder / "out/frame_0000.png"));
    CHECK(fs::exists(folder / "out/frame_0001.png"));
    CHECK(!fs::exists(folder / "out/frame_0002.png"));
    CHECK_THAT(content(folder / "out/stats.json"), Contains("\"frame_count\": 2"));
}

TEST_CASE("A trace becomes pictures, and a range of its frames a capture with the same ones") {
    const TemporaryFolder folder;
    const TemporaryFile file(trace::in_snappy(clears(4)));
    REQUIRE(run({"replay", file.path(), "-o", folder / "all"}) == 0);
    const Image red = read_image(folder / "all/frame_0002.png");
    CHECK(red.width == 8);
    CHECK(red.height == 4);
    CHECK(std::vector<std::uint8_t>(red.rgb.begin(), red.rgb.begin() + 3) ==
          std::vector<std::uint8_t>{255, 0, 0});

    REQUIRE(run({"replay",
                 file.path(),
                 "-o",
                 folder / "two",
                 "--frames",
                 "1-2",
                 "--capture",
                 folder / "two.ffc"}) == 0);
    CHECK(!fs::exists(folder / "two/frame_0000.png"));
    CHECK(!fs::exists(folder / "two/frame_0003.png"));
    REQUIRE(run({"replay", folder / "two.ffc", "-o", folder / "again"}) == 0);
    CHECK(run({"compare", folder / "two", folder / "again"}) == 0);
    CHECK(run({"compare", folder / "two", folder / "all"}) == 1); // Frames are missing.

    std::string damaged = content(folder / "two.ffc");
    damaged.resize(damaged.size() - 9);
    const TemporaryFile cut(damaged, ".ffc");
    CHECK(run({"replay", cut.path(), "-o", folder / "cut"}) == 2);
}

TEST_CASE("--samples smooths the edges of a trace's pictures") {
    const TemporaryFolder folder;
    const TemporaryFile file(trace::in_snappy(clears(1, true)));
    const auto green_of_edge = [&](const char* samples) -> int {
        REQUIRE(run({"replay", file.path(), "-o", folder / samples, "--samples", samples}) == 0);
        const Image picture = read_image(folder / samples + "/frame_0000.png");
        return picture.rgb.at(3 * 8 + 1); // the second row from the top, over red
    };
    const int single = green_of_edge("1");
    CHECK((single == 0 || single == 255));
    CHECK(green_of_edge("4") == 128);
    CHECK(run({"replay", file.path(), "-o", folder / "x", "--samples", "3"}) == 2);
    REQUIRE(run({"replay", file.path(), "--capture", folder / "c.ffc", "--samples", "4"}) == 0);
    REQUIRE(run({"replay", folder / "c.ffc", "-o", folder / "again"}) == 0);
    CHECK(run({"compare", folder / "4", folder / "again"}) == 0);
    CHECK(run({"replay", folder / "c.ffc", "-o", folder / "x", "--samples", "4"}) == 2);
}

TEST_CASE("Threads, heat maps and timing change neither pictures nor the functional figures") {
    const TemporaryFolder folder;
    const TemporaryFile file(trace::in_snappy(clears(3)));
    REQUIRE(run({"replay", file.path(), "-o", folder / "one", "--threads", "1"}) == 0);
    REQUIRE(run({"replay", file.path(), "-o", folder / "two", "--threads", "2"}) == 0);
    CHECK(content(folder / "one/stats.json") == content(folder / "two/stats.json"));
    REQUIRE(run({"replay", file.path(), "-o", folder / "timed", "--timing"}) == 0);
    CHECK(run({"compare", folder / "one", folder / "timed"}) == 0);
    CHECK(run({"replay", file.path(), "-o", folder / "x", "--heatmap", "cycles"}) == 2);
}

TEST_CASE("Frames that are not there are told of, and refused where none is") {
    const TemporaryFolder folder;
    const TemporaryFile file(trace::in_snappy(clears(3)));
    CHECK(run({"replay", file.path(), "-o", folder / "all", "--frames", "0-2"}) == 0);
    CHECK(run({"replay", file.path(), "-o", folder / "some", "--frames", "2-9"}) == 0);
    CHECK(run({"replay", file.path(), "-o", folder / "none", "--frames", "3-9"}) == 2);

    ReplayOptions options;
    options.input = file.path();
    std::string warning;
    options.warn = [&](const std::string& line) { warning += line; };
    options.frames = {0, 2};
    replay(options);
    CHECK(warning.empty());
    options.frames = {1, 9};
    replay(options);
    CHECK_THAT(warning, Contains("ends before frame 3, 9 was asked for"));
}

TEST_CASE("--set takes assignments, and leaves the input its place") {
    const TemporaryFolder folder;
    const TemporaryFile file(trace::in_snappy(clears(1)));
    const auto replay = [&](std::vector<std::string> words) {
        words.insert(words.begin(), {"replay", "-o", folder / "x"});
        return run(words);
    };
    CHECK(replay({"--set", "gpu.tile_size=32", file.path()}) == 0);
    CHECK(replay({"--set", "gpu.tile_size=32", "gpu.threads=1", file.path()}) == 0);
    CHECK(replay({file.path(), "--set", "gpu.threads=1", "texel_cache.ways=2", "--timing"}) == 0);
    CHECK(content(folder / "x/stats.json").find("\"ways\": 2") != std::string::npos);
    CHECK(replay({file.path(), "--set", "gpu.threads=1", "foo"}) == 2);
    CHECK(replay({file.path(), "--set", "gpu.threads=1", "gpu.wrong=1"}) == 2);
    CHECK(run({"config", "--set", "texel_cache.ways=2", "texel_cache.sets=8"}) == 0);
}

TEST_CASE("A value out of range is told of under the option that was given") {
    const TemporaryFolder folder;
    const TemporaryFile file(trace::in_snappy(clears(1)));
    const auto line = [&](const std::vector<std::string>& option) {
        std::vector<std::string> words{"replay", file.path(), "-o", folder / "x"};
        words.insert(words.end(), option.begin(), option.end());
        return printed(stderr, [&] { CHECK(run(words) == 2); });
    };
    CHECK_THAT(line({"--threads", "100000"}), StartsWith("ffgpu: --threads: "));
    CHECK_THAT(line({"--set", "gpu.threads=100000"}), StartsWith("ffgpu: --set: "));
    for (const std::string value :
         {"16x", "0x", "004", "=4", "\"a", "Sixteen", "99999999999999999999"})
        CHECK_THAT(line({"--set", "memory.queue=" + value}),
                   StartsWith("ffgpu: --set: memory.queue: expected an integer, "));
    CHECK_THAT(line({"--set", "memory.profile=DDR"}),
               StartsWith("ffgpu: --set: memory.profile: expected one of ") &&
                   Contains("found \"DDR\""));
}

TEST_CASE("What goes with --set is what has its form, up to two dashes") {
    using Words = std::vector<std::string>;
    CHECK(spread_settings({"run", "--set", "a.b=1", "c.d = 2", "in", "e.f=3"}) ==
          Words{"run", "--set", "a.b=1", "--set", "c.d = 2", "in", "e.f=3"});
    CHECK(spread_settings({"--set", "x", "a.b=1"}) == Words{"--set", "x", "--set", "a.b=1"});
    CHECK(spread_settings({"--set", "a.b=1", "--", "c.d=2"}) ==
          Words{"--set", "a.b=1", "--", "c.d=2"});
    CHECK(spread_settings({"--set", "a.b=1", "./c.d=2"}) == Words{"--set", "a.b=1", "./c.d=2"});
    CHECK(spread_settings({"--set", "a.b=1", "--set", "c.d=2"}) ==
          Words{"--set", "a.b=1", "--set", "c.d=2"});
}

TEST_CASE("An option that is unknown is named, even where something else is missing") {
    const std::string line = printed(stderr, [] { CHECK(run({"run", "--bogus"}) == 2); });
    CHECK_THAT(line, Contains("not expected: --bogus"));
}

TEST_CASE("A cache that cannot be held is named by its parameters") {
    const TemporaryFolder folder;
    const TemporaryFile file(trace::in_snappy(clears(1)));
    for (const char* const cache : {"texel_cache", "depth_cache", "color_cache"}) {
        const auto error = [&](const char* ways) {
            return printed(stderr, [&] {
                run({"replay",
                     file.path(),
                     "-o",
                     folder / "x",
                     "--timing",
                     "--set",
                     cache + std::string(".sets=1048576"),
                     cache + std::string(".ways=") + ways});
            });
        };
        CHECK_THAT(error("5"),
                   Contains(cache + std::string(".sets x ways: expected at most 4194304 lines, "
                                                "found 5242880")));
        CHECK_THAT(error("4"), !Contains("ways"));
    }
}

TEST_CASE("An empty file is a configuration without changes") {
    const TemporaryFile file("", ".toml");
    Configuration configuration;
    read_config_file(file.path(), configuration);
    CHECK(to_toml(configuration) == to_toml(Configuration{}));
    CHECK_THROWS_AS(read_config_file("/no/such/file.toml", configuration), InputError);
}

TEST_CASE("A configuration that is no text of a person is refused by its size") {
    const TemporaryFile file("", ".toml");
    std::filesystem::resize_file(file.path(), (16u << 20) + 1);
    Configuration configuration;
    CHECK_THROWS_WITH(read_config_file(file.path(), configuration), Contains("larger than 16 MiB"));
}

TEST_CASE("compare measures, and fails above its limit") {
    const TemporaryFolder folder;
    Image a(4, 2), b(4, 2);
    b.rgb[3 * 5 + 1] = 24;
    const Difference difference = compare_images(a, b);
    CHECK(difference.rmse == Approx(std::sqrt(24.0 * 24 / 24)));
    CHECK(difference.within_16 == Approx(7.0 / 8));
    CHECK(difference.worst_x == 1);
    CHECK(difference.worst_y == 1);
    CHECK(difference.worst_difference == 24);
    CHECK(std::isinf(compare_images(a, a).psnr));

    write_png(folder / "a.png", a);
    write_png(folder / "b.png", b);
    CHECK(run({"compare", folder / "a.png", folder / "a.png"}) == 0);
    CHECK(run({"compare", folder / "a.png", folder / "b.png"}) == 1);
    CHECK(run({"compare",
               folder / "a.png",
               folder / "b.png",
               "--max-rmse",
               "4.91",
               "--diff",
               folder / "d.png"}) == 0);
    CHECK(run({"compare", folder / "a.png", folder / "b.png", "--max-rmse", "4.8"}) == 1);
    CHECK(read_image(folder / "d.png").rgb[3 * 5 + 1] == 8 * 24);
}

TEST_CASE("compare passes over no picture, and compares with numbers from 0 alone") {
    const TemporaryFolder folder;
    write_png(folder / "a.png", Image(4, 2));
    CHECK(run({"compare", folder.path(), folder.path()}) == 0);
    CHECK(run({"compare", folder.path(), folder.path(), "--max-rmse", "nan"}) == 2);
    CHECK(run({"compare", folder.path(), folder.path(), "--max-rmse", "-1"}) == 2);
    fs::create_symlink(folder / "gone.png", folder / "b.png");
    CHECK(run({"compare", folder.path(), folder.path()}) == 2);
}

TEST_CASE("What is read more than once and comes by a pipe is told so") {
    int ends[2];
    REQUIRE(::pipe(ends) == 0);
    const std::string pipe = "/dev/fd/" + std::to_string(ends[0]);
    const auto told_of = [&](const std::vector<std::string>& arguments, const std::string& bytes) {
        REQUIRE(::write(ends[1], bytes.data(), bytes.size()) == std::ssize(bytes));
        const std::string told = printed(stderr, [&] { CHECK(run(arguments) == 2); });
        CHECK_THAT(told, Contains("a pipe") && Contains("a file was expected"));
    };
    const TemporaryFolder folder;
    write_png(folder / "a.png", Image(4, 2));
    told_of({"replay", pipe, "-o", folder / "out"}, capture_without_frames().substr(0, 1000));
    told_of({"cache", pipe}, "FFGPUWRK and more");
    told_of({"compare", pipe, folder / "a.png"}, content(folder / "a.png"));
    ::close(ends[0]);
    ::close(ends[1]);
}

TEST_CASE("The configuration reads what it prints") {
    Configuration configuration;
    configuration.gpu.tile_size = 32;
    configuration.timing.texel_cache.ways = 8;
    configuration.timing.texel_cache.layout = timing::Layout::Linear;
    const TemporaryFile file(to_toml(configuration), ".toml");
    Configuration read;
    read_config_file(file.path(), read);
    CHECK(to_toml(read) == to_toml(configuration));
    CHECK(to_toml(read) != to_toml(Configuration{}));
}

TEST_CASE("A wrong parameter is named with what was expected") {
    const auto error = [](const std::string& toml) -> std::string {
        const TemporaryFile file(toml, ".toml");
        Configuration configuration;
        try {
            read_config_file(file.path(), configuration);
        } catch (const InputError& wrong) {
            CHECK_THAT(wrong.what(), StartsWith(file.path()));
            return wrong.what();
        }
        return {};
    };
    CHECK_THAT(error("\n[texel_cache]\nwayz = 8\n"),
               Contains(":3: unknown parameter texel_cache.wayz") &&
                   Contains("did you mean texel_cache.ways?"));
    CHECK_THAT(error("[texl_cache]\n"), Contains("did you mean texel_cache?"));
    CHECK_THAT(error("[texel_cache]\nways = 0\n"), Contains("1 to 65536") && Contains("found 0"));
    CHECK_THAT(error("[texel_cache]\nsets = 48\n"), Contains("a power of two"));
    CHECK_THAT(error("[texel_cache]\nsets = \"64\"\n"), Contains("expected an integer"));
    CHECK_THAT(error("[texel_cache]\nlayout = \"square\"\n"), Contains("\"linear\", \"blocked\""));
    CHECK_THAT(error("texel_cache = 3\n"), Contains("is a table"));
    CHECK_THAT(error("[texel_cache\n"), Contains(":1"));
}

TEST_CASE("A switch is true or false, or on or off") {
    Configuration configuration;
    for (const auto& [word, is_on] : {std::pair{"off", false}, {"on", true}, {"false", false}}) {
        apply_setting(std::string("bottlenecks.enable=") + word, configuration);
        CHECK(configuration.timing.bottlenecks.enable == is_on);
    }
    for (const char* wrong : {"no", "1", "\"true\""})
        CHECK_THROWS_AS(apply_setting(std::string("bottlenecks.enable=") + wrong, configuration),
                        InputError);
}

TEST_CASE("Frame ranges are A-B, A or A-") {
    CHECK(parse_frame_range("3-7") == FrameRange{3, 7});
    CHECK(parse_frame_range("3") == FrameRange{3, 3});
    CHECK(parse_frame_range("3-").contains(1000000));
    for (const char* wrong : {"", "x", "-3", "7-3", "3-x", "3 7", "3-7-9"})
        CHECK_THROWS_AS(parse_frame_range(wrong), InputError);
}

} // namespace
} // namespace ffgpu::tools
