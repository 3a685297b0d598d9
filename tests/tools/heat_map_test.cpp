// Heat maps: colours, scales, means, legends, and the numbers behind them.

#include "model/base/input_error.h"
#include "tests/support/temporary_file.h"
#include "tests/support/temporary_folder.h"
#include "tests/tools/tool.h"
#include "tools/files/npy_file.h"
#include "tools/heatmap/heat_picture.h"

#include <bit>
#include <cstring>
#include <numeric>

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
}

} // namespace
} // namespace ffgpu::tools
