// What `ffgpu cache` writes: counts as CSV that add up, charts, pictures of where caches miss.

#include "model/base/input_error.h"
#include "model/work/lookup_walk.h"
#include "tests/support/temporary_file.h"
#include "tests/support/temporary_folder.h"
#include "tests/system/trace_run.h"
#include "tests/tools/tool.h"
#include "tests/work/plain_cache.h"
#include "tools/cache/cache_study.h"
#include "tools/work/work_player.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>

#include <catch2/catch.hpp>

namespace ffgpu::tools {
namespace {

using Catch::Matchers::Contains;

std::vector<std::map<std::string, std::string>> rows(const std::string& csv) {
    std::istringstream text(csv);
    std::vector<std::string> names;
    std::vector<std::map<std::string, std::string>> all;
    for (std::string line; std::getline(text, line);) {
        std::istringstream cells(line);
        std::vector<std::string> values;
        for (std::string cell; std::getline(cells, cell, ',');)
            values.push_back(cell);
        if (names.empty()) {
            names = values;
            continue;
        }
        REQUIRE(values.size() == names.size());
        for (std::size_t i = 0; i < names.size(); ++i)
            (i == 0 ? all.emplace_back() : all.back())[names[i]] = values[i];
    }
    return all;
}

std::string printed_tables(const std::vector<std::string>& arguments) {
    return printed(stdout, [&] { CHECK(run(arguments) == 0); });
}

TEST_CASE("the rows of curves.csv add up, and more ways never miss more", "[cache]") {
    const TemporaryFolder folder;
    const std::string tables = printed_tables({"cache",
                                               own_trace("chrome"),
                                               "-o",
                                               folder.path(),
                                               "--frames",
                                               "0-1",
                                               "--client",
                                               "texel,color",
                                               "--line",
                                               "64",
                                               "--order",
                                               "scanline,tiled:16"});
    CHECK_THAT(tables, Contains("texel, blocked, tiled 16, lines of 64 bytes"));
    CHECK_THAT(tables, Contains("color, blocked, scanline"));
    const auto all = rows(content(folder.path() + "/curves.csv"));
    CHECK(all.size() > 4 * 400);
    std::map<std::string, std::uint64_t> last; // misses in fewer ways, of as many sets
    for (auto row : all) {
        const auto at = [&](const std::string& name) { return std::stoull(row.at(name)); };
        CHECK(at("compulsory") + at("capacity") + at("conflict") == at("misses"));
        CHECK(at("compulsory") + at("reuse_quad") + at("reuse_tile") + at("reuse_primitive") +
                  at("reuse_draw") + at("reuse_frame") + at("reuse_earlier_frame") ==
              at("misses"));
        CHECK(at("bytes") == at("sets") * at("ways") * at("line_bytes"));
        CHECK(at("misses") <= at("accesses"));
        const std::string sets = row.at("client") + row.at("traversal") + ' ' + row.at("sets");
        const auto fewer = last.find(sets);
        if (fewer != last.end()) CHECK(at("misses") <= fewer->second);
        last[sets] = at("misses");
    }
    for (const auto& row : rows(content(folder.path() + "/working_sets.csv")))
        CHECK(std::stoull(row.at("bytes")) == 64 * std::stoull(row.at("lines")));
    const std::string chart = content(folder.path() + "/misses_texel_blocked_scanline_64.svg");
    CHECK(chart.rfind("<svg ", 0) == 0);
    CHECK_THAT(chart, Contains("</svg>"));
    std::size_t curves = 0;
    for (std::size_t at = 0; (at = chart.find("<polyline", at)) != std::string::npos; ++at)
        ++curves;
    CHECK(curves == 5);
}

TEST_CASE("what curves do not follow of the configured machine is told", "[cache]") {
    std::vector<std::string> lines;
    CacheStudyOptions options;
    options.input = own_trace("corridor");
    options.frames = {0, 0};
    options.most_sets = 1;
    options.warn = [&](const std::string& line) { lines.push_back(line); };
    timing::TimingConfig& timing = options.configuration.timing;
    timing.depth_cache.index_hash = work::IndexHash::Xor; // asked for by nobody
    CacheStudyResult result;
    study_caches(options, result);
    CHECK(lines.empty());
    timing.texel_cache.index_hash = work::IndexHash::Xor;
    timing.texel_cache.replacement = work::Replacement::Fifo;
    timing.texel_cache.per_pipe = true;
    timing.raster.quads_per_cycle = 2;
    study_caches(options, result);
    REQUIRE(lines.size() == 3);
    CHECK_THAT(lines[0], Contains("texel_cache.index_hash: not followed"));
    CHECK_THAT(lines[1], Contains("texel_cache.replacement: not followed"));
    CHECK_THAT(lines[2], Contains("texel_cache.per_pipe: not followed"));
}

// A part of a file, in a folder.
std::string part_of(const std::string& path, double part, const TemporaryFolder& folder) {
    std::ifstream file(path, std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(file), {}};
    bytes.resize(static_cast<std::size_t>(part * static_cast<double>(bytes.size())));
    const std::string name =
        folder / ("part_of_" + std::filesystem::path(path).filename().string());
    std::ofstream(name, std::ios::binary) << bytes;
    return name;
}

TEST_CASE("of an input that ends within a frame those before it are counted, no more", "[cache]") {
    const TemporaryFolder folder;
    const std::string work = folder / "corridor.ffw";
    REQUIRE(run({"replay",
                 own_trace("corridor"),
                 "--no-images",
                 "--save-work",
                 work,
                 "-o",
                 folder.path()}) == 0);
    struct Case {
        std::string input, trace;
        double part;
    };
    for (const Case& of : {Case{own_trace("light_maps"), own_trace("light_maps"), 0.85},
                           Case{work, own_trace("corridor"), 0.6}}) {
        CacheStudyOptions options{.input = part_of(of.input, of.part, folder), .most_sets = 1};
        options.clients = {work::LookupClient::Texel, work::LookupClient::Depth};
        CacheStudyResult cut, expected;
        CHECK_THROWS_AS(study_caches(options, cut), InputError);
        REQUIRE(!cut.frames.empty());
        options.input = of.trace;
        options.frames = {cut.frames.front(), cut.frames.back()};
        study_caches(options, expected);
        REQUIRE(cut.frames == expected.frames);
        REQUIRE(cut.curves.size() == expected.curves.size());
        for (std::size_t i = 0; i < cut.curves.size(); ++i) {
            CHECK(cut.curves[i].reads == expected.curves[i].reads);
            CHECK(cut.curves[i].sums.counts(1, 16) == expected.curves[i].sums.counts(1, 16));
            CHECK(cut.curves[i].frame_lines == expected.curves[i].frame_lines);
        }
    }
}

// The warnings of a call.
std::vector<std::string> warnings_of(const std::vector<std::string>& arguments) {
    std::istringstream text(printed(stderr, [&] { CHECK(run(arguments) == 0); }));
    std::vector<std::string> lines;
    for (std::string line; std::getline(text, line);)
        if (line.starts_with("ffgpu: warning: ")) lines.push_back(line);
    return lines;
}

TEST_CASE("what look-ups do not follow is told by cache and by din", "[cache]") {
    const TemporaryFolder folder;
    struct Case {
        std::string client, setting, warning; // empty: none
    };
    for (const Case& of : {
             Case{"texel", "texel_cache.forgets=true", "texel_cache.forgets: not followed"},
             Case{"depth", "texel_cache.forgets=true", ""},
             Case{"texel", "hierarchical_depth.keeps=max", "hierarchical_depth.keeps: not follow"},
             Case{"depth", "hierarchical_depth.keeps=max", "hierarchical_depth.keeps: not follow"},
             Case{"color", "hierarchical_depth.keeps=max", ""},
             Case{"depth", "depth_cache.enable=false", "depth_cache.enable=false: not followed"},
             Case{"color", "color_cache.enable=false", "color_cache.enable=false: not followed"},
             Case{"texel", "color_cache.enable=false", ""},
             Case{"vertex", "vertex.index_cache_lines=0", "vertex.index_cache_lines=0: not follow"},
             Case{"texel", "vertex.index_cache_lines=0", ""},
             Case{"texel", "raster.quads_per_cycle=4", "raster.quads_per_cycle: not followed"},
             Case{"vertex", "raster.quads_per_cycle=4", ""},
             Case{"color", "raster.architecture=tile_based", "color_cache: raster.architecture"},
             Case{"texel", "raster.architecture=tile_based", ""},
         }) {
        INFO(of.client << ", " << of.setting);
        const std::vector<std::string> common{
            own_trace("corridor"), "--frames", "0", "--client", of.client, "--set", of.setting};
        const TemporaryFolder out; // Charts of another case would be told of.
        std::vector<std::string> curves{"cache", "--most-sets", "1", "-o", out.path()};
        std::vector<std::string> lookups{"export", "--format", "xdin", "-o", folder / "lookups"};
        curves.insert(curves.end(), common.begin(), common.end());
        lookups.insert(lookups.end(), common.begin(), common.end());
        std::vector<std::string> lines;
        printed(stdout, [&] { lines = warnings_of(curves); });
        CHECK(warnings_of(lookups) == lines);
        REQUIRE(lines.size() == !of.warning.empty());
        if (!lines.empty()) CHECK_THAT(lines[0], Contains(of.warning));
    }
}

TEST_CASE("the machine of the RTL pipe is told to be another than the curves'", "[cache]") {
    std::vector<std::string> lines;
    printed(stdout, [&] {
        lines = warnings_of({"cache",
                             own_trace("corridor"),
                             "--frames",
                             "0",
                             "--most-sets",
                             "1",
                             "--client",
                             "texel,depth,color",
                             "--config",
                             "preset:rtl_pipe"});
    });
    REQUIRE(lines.size() == 3);
    CHECK_THAT(lines[0], Contains("texel_cache.forgets"));
    CHECK_THAT(lines[1], Contains("depth_cache.enable=false"));
    CHECK_THAT(lines[2], Contains("color_cache.enable=false"));
}

// Misses of a plain cache, by quad.
class QuadMisses final : public work::LookupSink {
public:
    explicit QuadMisses(const CacheGeometry& shape)
        : cache_(shape.sets, shape.ways) {}

    void lookups(work::LookupClient client,
                 const work::LookupPlace& place,
                 std::span<const work::LineLookup> lines,
                 std::uint32_t) override {
        if (client != work::LookupClient::Texel) return;
        for (const work::LineLookup& lookup : lines)
            misses[{place.x / 2, place.y / 2}] += !cache_.access(lookup.line, false);
    }
    void flush(work::LookupClient) override {}
    void overwritten(work::LookupClient, std::span<const work::OverwrittenLine>) override {}
    void end_frame(std::uint32_t) override {}

    std::map<std::pair<unsigned, unsigned>, unsigned> misses;

private:
    test::PlainCache cache_;
};

TEST_CASE("a miss map shows the misses of each quad", "[cache]") {
    const TemporaryFolder folder;
    const std::string trace = own_trace("corridor");
    printed_tables({"cache",
                    trace,
                    "-o",
                    folder.path(),
                    "--frames",
                    "0",
                    "--line",
                    "128",
                    "--miss-map",
                    "16x2x32"});
    const Image map = read_image(folder.path() + "/miss_map_0000.png");
    work::WorkConfig config;
    config.texel_cache.line_bytes = 32;
    QuadMisses plain({16, 2, 32});
    work::LookupWalk walk(config, {}, plain);
    work::MachineOrder order(config, walk);
    play_work({.input = trace, .frames = {0, 0}}, order, [](const work::FrameFigures&) {});
    std::array<unsigned, 4> seen{};
    unsigned wrong = 0;
    for (unsigned y = 0; y < map.height; ++y)
        for (unsigned x = 0; x < map.width; ++x) {
            const std::uint8_t* const pixel = &map.rgb[3 * (std::size_t{y} * map.width + x)];
            const std::uint8_t strongest = *std::max_element(pixel, pixel + 3);
            const unsigned color = strongest == 0          ? 0
                                   : pixel[2] == strongest ? 1
                                   : pixel[1] == strongest ? 2
                                                           : 3; // blue, green, red
            const auto found = plain.misses.find({x / 2, (map.height - 1 - y) / 2});
            const unsigned misses = found == plain.misses.end() ? 0 : found->second;
            wrong += color != std::min(misses, 3u);
            ++seen[color];
        }
    CHECK(wrong == 0);
    for (const unsigned count : seen)
        CHECK(count > 100);
}

TEST_CASE("what is wrong with a study is one line, and status 2", "[cache]") {
    const std::string trace = own_trace("corridor");
    const auto fails = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), {"cache", trace});
        int status = 0;
        std::string text = printed(stderr, [&] { status = run(arguments); });
        CHECK(status == 2);
        CHECK(std::count(text.begin(), text.end(), '\n') == 1);
        return text;
    };
    CHECK_THAT(fails({"--line", "48"}), Contains("--line 48: expected a power of two"));
    CHECK_THAT(fails({"--client", "texels"}), Contains("did you mean 'texel'?"));
    CHECK_THAT(fails({"--layout", "block"}), Contains("did you mean 'blocked'?"));
    CHECK_THAT(fails({"--order", "tiled:7"}), Contains("--order tiled:7"));
    CHECK_THAT(fails({"--order", "tilde"}), Contains("did you mean 'tiled'?"));
    CHECK_THAT(fails({"--first-level", "64x4"}), Contains("SETSxWAYSxBYTES"));
    CHECK_THAT(fails({"--first-level", "64x4x64", "--line", "32"}), Contains("at least"));
    CHECK_THAT(fails({"--first-level", "64x4x64", "--client", "depth"}), Contains("texel among"));
    CHECK_THAT(fails({"--most-sets", "100"}), Contains("--most-sets 100"));
    CHECK_THAT(fails({"--miss-map", "64x4x64"}), Contains("-o DIR"));
    CHECK_THAT(fails({"-o", "/proc/nothing"}), Contains("/proc/nothing"));
}

} // namespace
} // namespace ffgpu::tools
