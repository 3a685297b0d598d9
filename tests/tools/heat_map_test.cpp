// Heat maps: colours, scales, means, legends, and the numbers behind them.

#include "model/base/input_error.h"
#include "tests/support/temporary_file.h"
#include "tests/support/temporary_folder.h"
#include "tests/tools/scene_trace.h"
#include "tests/tools/tool.h"
#include "tools/files/npy_file.h"
#include "tools/heatmap/heat_picture.h"

#include <bit>
#include <cstring>
#include <numeric>
#include <set>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

namespace ffgpu::tools {
namespace {

using Catch::Matchers::Contains;
using Color = std::array<std::uint8_t, 3>;

constexpr Color Black{0, 0, 0}, White{255, 255, 255}, Green{0, 255, 0};

Color color_at(const Image& image, unsigned x, unsigned y) {
    Color color{};
    std::copy_n(&image.rgb.at(3 * (std::size_t{image.width} * y + x)), 3, color.begin());
    return color;
}

// Of a .npy file: what stands behind its head.
std::vector<float> numbers_in(const std::string& path) {
    const std::string bytes = content(path);
    REQUIRE(bytes.size() > 10);
    const std::size_t head = 10 + static_cast<std::uint8_t>(bytes[8]) +
                             256 * std::size_t{static_cast<std::uint8_t>(bytes[9])};
    std::vector<float> values((bytes.size() - head) / sizeof(float));
    std::memcpy(values.data(), bytes.data() + head, values.size() * sizeof(float));
    return values;
}

double sum_of(const std::string& path) {
    const std::vector<float> values = numbers_in(path);
    return std::accumulate(values.begin(), values.end(), 0.0);
}

TEST_CASE("A .npy file has the head that NumPy's format asks for") {
    const TemporaryFolder folder;
    const std::vector<float> values{1, 2, 3, 4, 5, -6.5f};
    write_npy(folder / "a.npy", 3, values);
    const std::string bytes = content(folder / "a.npy");
    CHECK(bytes.substr(0, 8) == std::string("\x93NUMPY\x01\0", 8));
    CHECK_THAT(bytes, Contains("{'descr': '<f4', 'fortran_order': False, 'shape': (2, 3), }"));
    const std::size_t head = bytes.size() - sizeof(float) * values.size();
    CHECK(head % 64 == 0);
    CHECK(bytes[head - 1] == '\n');
    CHECK(numbers_in(folder / "a.npy") == values);
}

TEST_CASE("Means over squares keep the sum, also where the squares are cut off") {
    HeatPlane plane{3, 3, {0, 4, 8, 4, 8, 2, 6, 2, 9}};
    const HeatPlane means = averaged(plane, 2);
    CHECK(means.values == std::vector<float>{4, 4, 5, 4, 4, 5, 4, 4, 9});
    CHECK(averaged(plane, 1).values == plane.values);
    CHECK(averaged(plane, 100).values == std::vector<float>(9, 43.0f / 9));
}

TEST_CASE("A heat map has a legend below it, and its scale as wanted") {
    HeatPlane plane{100, 1, std::vector<float>(100, 0)};
    plane.values[3] = 4;
    plane.values[5] = 2;
    const Image frame(100, 1);
    const Image usual = heat_picture(HeatMap::Overdraw, plane, {}, frame);
    CHECK(color_at(usual, 0, 0) == Black);
    CHECK(color_at(usual, 3, 0) == Green); // half of 8
    REQUIRE(usual.height > 1 + 16);
    CHECK(color_at(usual, 0, 6) == Black); // the ramp
    CHECK(color_at(usual, 99, 6) == White);
    CHECK(color_at(usual, 50, 6)[1] == 255);
    HeatMapOptions options;
    options.full_scale = 0;
    const Image automatic = heat_picture(HeatMap::Overdraw, plane, options, frame);
    CHECK(color_at(automatic, 3, 0) == White);
    CHECK(color_at(automatic, 5, 0) == Green);
    CHECK(automatic.rgb != usual.rgb);
    HeatPlane large{100, 100, std::vector<float>(10000, 3)};
    std::fill_n(large.values.begin(), 50, 1000.0f); // one in 200
    CHECK(color_at(heat_picture(HeatMap::Overdraw, large, options, Image(100, 100)), 0, 99) ==
          White);
    large.values[50] = 1000;
    CHECK(color_at(heat_picture(HeatMap::Overdraw, large, options, Image(100, 100)), 0, 99) !=
          White);
    options.full_scale = 2;
    CHECK(color_at(heat_picture(HeatMap::Overdraw, plane, options, frame), 5, 0) == White);
}

TEST_CASE("A blended heat map is half the frame, in grey") {
    const HeatPlane plane{2, 1, {0, 8}};
    Image frame(2, 1);
    frame.rgb = {255, 255, 255, 0, 0, 0};
    HeatMapOptions options;
    options.blend = true;
    const Image image = heat_picture(HeatMap::Overdraw, plane, options, frame);
    CHECK(color_at(image, 0, 0) == Color{127, 127, 127});
    CHECK(color_at(image, 1, 0) == Color{127, 127, 127}); // white over black
}

TEST_CASE("The heat ramp runs from black over blue, green and red to white") {
    CHECK(heat_color(0) == Color{0, 0, 0});
    CHECK(heat_color(1.0 / 6) == Color{0, 0, 255});
    CHECK(heat_color(0.5) == Color{0, 255, 0});
    CHECK(heat_color(5.0 / 6) == Color{255, 0, 0});
    CHECK(heat_color(7) == Color{255, 255, 255});
    CHECK(parse_heat_scale("auto") == 0);
    CHECK(parse_heat_scale("2.5") == 2.5);
    for (const char* const wrong : {"0", "-1", "x", "1x", "inf", ""})
        CHECK_THROWS_WITH(parse_heat_scale(wrong), Contains("expected auto or a number above 0"));
    CHECK_THROWS_WITH(parse_heat_maps("overdrow"), Contains("did you mean overdraw?"));
    CHECK(parse_heat_maps("level,overdraw").size() == 2);
}

// The number of a name, from 1.
float number_of(timing::Resource resource) {
    return static_cast<float>(resource) + 1;
}

TEST_CASE("A quad's stall cause is what most of its cycles were waited for, over the frame") {
    auto state = std::make_shared<Registers>();
    Surface& target = state->targets.color[0];
    target = {.address = 64, .format = Format::Rgba8, .width = 4, .height = 2, .stride = 16};
    auto bin = std::make_shared<WorkBin>();
    bin->draws.push_back({.kind = WorkKind::Draw, .state = state});
    bin->tiles.emplace_back().batches.emplace_back().quads.emplace_back();
    HeatRecorder recorder;
    recorder.bin(bin);
    // Cycles 1 to 10, 11 to 14 and 15 to 16; the other quad retires with the last and has none.
    recorder.quad_retired({.x = 0, .y = 0, .cycles = 10, .end = 10});
    recorder.quad_retired({.x = 2, .y = 0, .cycles = 4, .end = 14});
    recorder.quad_retired({.x = 0, .y = 0, .cycles = 2, .end = 16});
    using timing::Resource;
    const std::vector<timing::WaitPaths::Run> waited{{4, Resource::Texture},
                                                     {9, Resource::MemoryLatency},
                                                     {13, Resource::Depth},
                                                     {16, Resource::Texture}};
    recorder.frame_waited(waited);
    // Quad 0: texture 4 + 2, latency 5, depth 1. Quad 1: depth 3, texture 1.
    const HeatPlane plane = recorder.plane(HeatMap::StallCause, target);
    const float texture = number_of(Resource::Texture), depth = number_of(Resource::Depth);
    CHECK(plane.values ==
          std::vector<float>{texture, texture, depth, depth, texture, texture, depth, depth});
}

TEST_CASE("A map of names has squares of the most common one, and a legend of those that occur") {
    const float texture = number_of(timing::Resource::Texture);
    const float color = number_of(timing::Resource::Color);
    const HeatPlane plane{200, 1, std::vector<float>(200, texture)};
    HeatPlane mixed = plane;
    for (std::size_t i = 0; i < 3; ++i)
        mixed.values[i] = color;
    mixed.values[9] = color;
    const HeatPlane squares = most_common(mixed, 4);
    CHECK(std::count(squares.values.begin(), squares.values.end(), color) == 4);
    CHECK(squares.values[3] == color);
    CHECK(squares.values[9] == texture);
    const Image frame(200, 1);
    const Image one = heat_picture(HeatMap::StallCause, plane, {}, frame);
    const Image two = heat_picture(HeatMap::StallCause, mixed, {}, frame);
    const auto occurs = [](const Image& image, Color wanted) {
        for (unsigned y = 1; y < image.height; ++y)
            for (unsigned x = 0; x < image.width; ++x)
                if (color_at(image, x, y) == wanted) return true;
        return false;
    };
    CHECK(color_at(two, 0, 0) == name_color(static_cast<std::size_t>(color)));
    CHECK(occurs(one, name_color(static_cast<std::size_t>(texture))));
    CHECK(!occurs(one, name_color(static_cast<std::size_t>(color))));
    CHECK(occurs(two, name_color(static_cast<std::size_t>(color))));
    std::set<Color> colors;
    for (std::size_t number = 0; number <= timing::Resources; ++number)
        colors.insert(name_color(number));
    CHECK(colors.size() == timing::Resources + 1);
}

// The lower left quarter of a window of 32x32 is drawn over its clear colour.
TEST_CASE("Maps of blocks tell the bytes of each: none where a clear wrote the state alone") {
    SceneTrace scene;
    scene.call("glClear", GlEnum{0x4100});
    scene.call("glEnable", GlEnum{0x0b71}); // the depth test
    scene.call("glColor3f", 1.0f, 0.0f, 0.0f);
    scene.call("glRectf", -1.0f, -1.0f, 0.0f, 0.0f);
    scene.swap();
    const TemporaryFolder folder;
    const TemporaryFile file(scene.file());
    const auto replay = [&](std::vector<std::string> settings) {
        std::vector<std::string> arguments{"replay",
                                           file.path(),
                                           "-o",
                                           folder / "out",
                                           "--timing",
                                           "--heatmap",
                                           "depth_blocks,color_blocks,stall_cause",
                                           "--heatmap-npy"};
        for (const std::string& setting : settings)
            arguments.insert(arguments.end(), {"--set", setting});
        return run(arguments);
    };
    REQUIRE(replay({"depth_blocks.fast_clear=true", "color_blocks.fast_clear=true"}) == 0);
    for (const char* const map : {"depth_blocks", "color_blocks"}) {
        const auto bytes = numbers_in(folder / "out/heat_" + std::string(map) + "_0000.npy");
        REQUIRE(bytes.size() == 32 * 32);
        for (unsigned row = 0; row < 32; ++row)
            for (unsigned x = 0; x < 32; ++x)
                REQUIRE(bytes[32 * row + x] == (row >= 16 && x < 16 ? 64 : 0));
    }
    const auto causes = numbers_in(folder / "out/heat_stall_cause_0000.npy");
    CHECK(std::count(causes.begin(), causes.end(), 0.0f) >= 3 * 256);
    CHECK(std::count(causes.begin(), causes.end(), 0.0f) < 1024);
    CHECK(replay({"depth_blocks.fast_clear=true"}) == 2);
    CHECK(replay({"depth_blocks.fast_clear=true",
                  "color_blocks.fast_clear=true",
                  "bottlenecks.enable=false"}) == 2);
}

TEST_CASE("A quad that the alpha test ends has its misses in the map") {
    SceneTrace scene;
    scene.texture(Luminance, 4, std::string(16, 'x'), Nearest);
    scene.call("glEnable", GlEnum{0x0bc0});          // alpha test
    scene.call("glAlphaFunc", GlEnum{0x0204}, 0.5f); // greater
    scene.call("glColor4f", 1.0f, 1.0f, 1.0f, 0.0f);
    scene.call("glRectf", -0.5f, -0.5f, 0.5f, 0.5f);
    scene.swap();
    const TemporaryFolder folder;
    const TemporaryFile file(scene.file());
    REQUIRE(run({"replay",
                 file.path(),
                 "-o",
                 folder / "out",
                 "--timing",
                 "--heatmap",
                 "texture_misses,alpha_killed",
                 "--heatmap-npy"}) == 0);
    CHECK(sum_of(folder / "out/heat_alpha_killed_0000.npy") == 256);
    // One line holds the texture; its miss is at the four pixels of one quad.
    CHECK(sum_of(folder / "out/heat_texture_misses_0000.npy") == 4);
    const auto figures = nlohmann::json::parse(content(folder / "out/stats.json"))["totals"];
    CHECK(figures["timing"]["texel_cache_misses"] == 1);
}

TEST_CASE("The numbers of a heat map add up to the statistics of its frame") {
    const TemporaryFolder folder;
    const TemporaryFile file(trace::in_snappy(clears(1, true)));
    REQUIRE(run({"replay",
                 file.path(),
                 "-o",
                 folder / "out",
                 "--heatmap",
                 "overdraw,covered,depth_killed,alpha_killed,stencil_killed,quad_lanes,texture",
                 "--heatmap-npy",
                 "--heatmap-tile",
                 "2"}) == 0);
    const auto sum = [&](const std::string& map) {
        return sum_of(folder / "out/heat_" + map + "_0000.npy");
    };
    const auto figures =
        nlohmann::json::parse(content(folder / "out/stats.json"))["totals"]["functional"];
    CHECK(sum("overdraw") == figures["fragments_written"].get<double>());
    CHECK(sum("covered") == figures["fragments_covered"].get<double>());
    CHECK(sum("overdraw") > 0);
    CHECK(sum("depth_killed") + sum("alpha_killed") + sum("stencil_killed") == 0);
    CHECK(sum("texture") == 0);
    // Quads in the white rows: the lower row is whole in each, the upper one too, or not at all.
    const std::vector<float> lanes = numbers_in(folder / "out/heat_quad_lanes_0000.npy");
    REQUIRE(lanes.size() == 32);
    CHECK(*std::ranges::max_element(lanes) <= 4);
    CHECK(run({"replay", file.path(), "-o", folder / "x", "--heatmap-tile", "0"}) == 2);
    CHECK(run({"replay", file.path(), "-o", folder / "x", "--heatmap-npy"}) == 2);
    CHECK(run({"replay", file.path(), "-o", folder / "x", "--heatmap-npy", "--view", "level"}) ==
          0);
}

} // namespace
} // namespace ffgpu::tools
