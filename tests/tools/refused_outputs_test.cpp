// What a command that is refused leaves: what was there before, and nothing else.

#include "tests/support/temporary_file.h"
#include "tests/support/temporary_folder.h"
#include "tests/tools/tool.h"

#include <filesystem>

#include <catch2/catch.hpp>

namespace ffgpu::tools {
namespace {

using Catch::Matchers::Contains;
namespace fs = std::filesystem;

std::string said(const std::vector<std::string>& words, int status = 2) {
    return printed(stderr, [&] { CHECK(run(words) == status); });
}

// A work file of two frames, with draws but without values.
std::string work_in(const TemporaryFolder& folder) {
    const TemporaryFile trace(trace::in_snappy(clears(2, true)));
    const std::string work = folder / "two.ffw";
    said({"replay", trace.path(), "--no-images", "--save-work", work}, 0);
    return work;
}

TEST_CASE("An empty value is one line and exit status 2, whatever the option") {
    const TemporaryFolder folder;
    const std::string work = work_in(folder);
    const std::vector<std::vector<std::string>> cases{
        {"cache", work, "--config", ""},
        {"cache", work, "--first-level", ""},
        {"cache", work, "--line", ""},
        {"cache", work, "-o", ""},
        {"cache", work, "--miss-map", ""},
        {"export", work, "--format", "din", "-o", "-", "--config", ""},
        {"export", work, "--format", "din", "-o", ""},
        {"time", work, "-o", folder / "o", "--config", ""},
        {"time", work, "-o", folder / "o", "--totals", ""},
        {"report", folder.path(), ""},
        {"report", folder.path(), "--point", ""},
        {"diff", work, ""},
        {"info", ""},
        {"config", "--config", ""},
        {"explain", work, "--frame", "0", "--pixel", "1,1", "--explain-region", ""},
    };
    for (const std::vector<std::string>& words : cases) {
        const std::string line = said(words);
        INFO(words[0] << ' ' << words[words.size() - 2] << ": " << line);
        CHECK_THAT(line, Contains("expected a value"));
        CHECK(line.find('\n') == line.size() - 1);
    }
    CHECK_FALSE(fs::exists(folder / "o"));
}

TEST_CASE("A folder in the place of a file is refused before the work") {
    const TemporaryFolder folder;
    const std::string work = work_in(folder), there = folder / "there";
    fs::create_directory(there);
    const std::vector<std::vector<std::string>> cases{
        {"time", work, "--totals", there},
        {"export", work, "--format", "din", "-o", there},
        {"explain", work, "--frame", "0", "--pixel", "1,1", "--footprint", there},
    };
    for (const std::vector<std::string>& words : cases) {
        const std::string line = said(words);
        INFO(words[0] << ": " << line);
        CHECK_THAT(line, Contains(words[words.size() - 2] + " " + there + ": is a folder"));
    }
    CHECK(fs::is_empty(there));
}

TEST_CASE("A command that writes nothing leaves no folder") {
    const TemporaryFolder folder;
    const std::string work = work_in(folder), missing = folder / "missing.ffw";
    fs::create_directory(folder / "there");
    for (const std::string& output :
         {folder / "new", folder / "new/deep/er", folder / "new/", folder / "there"}) {
        said({"cache", missing, "-o", output});
        said({"time", missing, "-o", output});
        said({"replay", missing, "-o", output});
        said({"time",
              work,
              "-o",
              output,
              "--set",
              "color_cache.enable=false",
              "raster.quads_per_cycle=4"});
        said({"time", work, "-o", output, "--set", "depth.test=late"});
        CHECK_FALSE(fs::exists(folder / "new"));
    }
    CHECK(fs::is_empty(folder / "there"));
}

TEST_CASE("A machine that is refused leaves the statistics of the one before") {
    const TemporaryFolder folder;
    const std::string work = work_in(folder), stats = folder / "o/stats.json";
    said({"time", work, "-o", folder / "o"}, 0);
    const std::string before = content(stats);
    CHECK_THAT(before, Contains("\"frame_count\": 2"));
    CHECK_THAT(said({"time", work, "-o", folder / "o", "--set", "depth.test=late"}),
               Contains("values"));
    CHECK(content(stats) == before);
}

TEST_CASE("A file of a run's folder is not written over, and a configuration in it neither") {
    const TemporaryFolder folder;
    const std::string work = work_in(folder), run_folder = folder / "o";
    said({"time", work, "-o", run_folder}, 0);
    for (const char* const name : {"stats.json", "pictures.csv", "frame_0000.png", "draws.csv"})
        CHECK_THAT(said({"report", run_folder, "-o", run_folder + "/" + name}),
                   Contains("may be a file of"));
    said({"time", work, "-o", run_folder, "--totals", run_folder + "/stats.json"});
    const std::string config = run_folder + "/curves.csv";
    printed(stdout, [&] { CHECK(run({"config"}) == 0); });
    std::ofstream(config) << "[texel_cache]\nways = 1\n";
    said({"cache", work, "-o", run_folder, "--config", config});
    CHECK(content(config) == "[texel_cache]\nways = 1\n");
}

TEST_CASE("config refuses what no machine is made of") {
    CHECK_THAT(said({"config", "--set", "color_cache.enable=false", "raster.quads_per_cycle=4"}),
               Contains("color_cache.enable"));
}

} // namespace
} // namespace ffgpu::tools
