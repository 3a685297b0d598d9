// Every technique against its oracle, and every oracle against a program that does one thing wrong.

#include "tests/gallery/offscreen/draw.h"
#include "tests/gallery/oracles/floor_average.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <string_view>

#include <catch2/catch.hpp>

namespace ffgpu::gallery {
namespace {

namespace fs = std::filesystem;

const Program& program(std::string_view row) {
    for (const Program& each : programs()) {
        if (each.row == row) return each;
    }
    FAIL("no program of row " << row);
    return programs().front();
}

TEST_CASE("the gallery has the textbook's 26 rows, and each program the oracle of its row") {
    REQUIRE(programs().size() == 26);
    REQUIRE(claims().size() == 26);
    for (std::size_t i = 0; i < programs().size(); ++i) {
        CHECK(programs()[i].row.substr(1) == std::to_string(i + 1));
        CHECK(claims()[i].row == programs()[i].row);
    }
}

TEST_CASE("each technique draws what its formula says, and a broken one does not") {
    for (std::size_t i = 0; i < programs().size(); ++i) {
        const Claim& claim = claims()[i];
        const Difference found = difference(draw_offscreen(programs()[i], false), claim);
        const Difference broken = difference(draw_offscreen(programs()[i], true), claim);
        std::cout << claim.row << ' ' << programs()[i].name << ": worst " << found.worst << " of "
                  << claim.worst_allowed << ", rms " << found.rms << " of " << claim.rms_allowed
                  << "; broken: worst " << broken.worst << ", rms " << broken.rms << '\n';
        INFO(claim.row << ' ' << programs()[i].name << " at " << found.worst_x << ','
                       << found.worst_y);
        CHECK(found.worst <= claim.worst_allowed);
        CHECK(found.rms <= claim.rms_allowed);
        INFO("The oracle does not notice: " << claim.mutation);
        CHECK_FALSE(holds(broken, claim));
    }
}

// Root mean square difference from the area average, of each of the three strips.
std::array<double, 3> strip_errors(const Picture& picture) {
    const Image image = gravel(256, 5);
    const Eye eye = grazing_eye(320.0 / 80);
    std::array<double, 3> sums{};
    for (int i = 0; i < WindowWidth * WindowHeight; ++i) {
        const glm::dvec2 window(i % WindowWidth + 0.5, static_cast<int>(i / WindowWidth) + 0.5);
        const Place place = place_in(window, 1, 3);
        const Color average = area_average(image, eye, place, 16);
        for (int channel = 0; channel < 3; ++channel) {
            const int at = 3 * i + channel;
            const double value = picture[static_cast<std::size_t>(at)];
            const double error = value - 255 * average[channel];
            sums[static_cast<std::size_t>(place.panel)] += error * error;
        }
    }
    for (double& sum : sums)
        sum = std::sqrt(sum / (WindowWidth * WindowHeight));
    return sums;
}

TEST_CASE("anisotropic probes are nearer to the area average than trilinear, more are nearer") {
    const auto [one, four, sixteen] = strip_errors(draw_offscreen(program("T8"), false));
    std::cout << "T8: rms from the area average: trilinear " << one << ", 4 probes " << four
              << ", 16 probes " << sixteen << '\n';
    CHECK(four < 0.75 * one);
    CHECK(sixteen < four);
}

TEST_CASE("the better the filter, the nearer to the area average") {
    std::map<std::string_view, double> rms;
    for (const Program& filter : filter_strip()) {
        rms[filter.name] = difference(draw_offscreen(filter, false), claim_of(filter.row)).rms;
        std::cout << filter.row << ' ' << filter.title << ": rms " << rms[filter.name] << '\n';
    }
    const auto fall = [&](std::initializer_list<std::string_view> names) {
        double last = 256;
        for (const std::string_view name : names) {
            INFO(name);
            CHECK(rms.at(name) < last);
            last = rms.at(name);
        }
    };
    fall({"filter_trilinear",
          "filter_anisotropic_2",
          "filter_anisotropic_4",
          "filter_anisotropic_8",
          "filter_anisotropic_16"});
    fall({"filter_bilinear", "supersampled_4", "supersampled_8", "supersampled_16"});
    for (const auto name :
         {"filter_rip_map", "filter_summed_area", "filter_elliptic", "filter_feline"})
        fall({"filter_trilinear", name});
}

// As golden_frames.tsv has it: of the RGB bytes, the top row first, 64-bit FNV-1a.
std::uint64_t hash_of(const Picture& picture) {
    constexpr std::size_t Row = std::size_t{3} * WindowWidth;
    std::uint64_t hash = 0xcbf29ce484222325;
    for (std::size_t row = WindowHeight; row-- > 0;)
        for (std::size_t i = 0; i < Row; ++i)
            hash = (hash ^ picture[row * Row + i]) * 0x100000001b3;
    return hash;
}

TEST_CASE("the picture that the trace of a program has to show is the one that it draws") {
    std::map<std::string, std::string> hashes; // of traces of one frame
    std::ifstream file(FFGPU_SOURCE_DIR "/tests/system/golden_frames.tsv");
    for (std::string line; std::getline(file, line);) {
        std::istringstream fields(line);
        std::string trace, frame, width, height, hash;
        if (fields >> trace >> frame >> width >> height >> hash && frame == "0")
            hashes[trace] = hash;
    }
    std::size_t traces = 0;
    for (const auto& entry : fs::directory_iterator(FFGPU_SOURCE_DIR "/traces/gallery")) {
        const std::string name = entry.path().stem().string();
        INFO(name);
        const Program* const program = find_program(name);
        REQUIRE(program);
        const std::uint64_t drawn = hash_of(draw_offscreen(*program, false));
        CHECK(drawn == std::stoull(hashes["gallery/" + name], nullptr, 16));
        ++traces;
    }
    CHECK(traces > 0);
}

// Pixels that differ between two panels of a grid.
int differing(const Picture& picture, const Panel& a, const Panel& b) {
    int count = 0;
    for (int i = 0; i < a.width * a.height; ++i) {
        const int x = i % a.width, y = i / a.width;
        bool same = true;
        for (int channel = 0; channel < 3; ++channel) {
            const auto at = [&](const Panel& panel) {
                const int pixel = (panel.y + y) * WindowWidth + panel.x + x,
                          byte = 3 * pixel + channel;
                return picture[static_cast<std::size_t>(byte)];
            };
            same = same && at(a) == at(b);
        }
        count += !same;
    }
    return count;
}

TEST_CASE("no painter's order of the cycle is right; the z-buffer needs none") {
    const Picture picture = draw_offscreen(program("T19"), false);
    const Scene scene{};
    for (int order = 0; order < 6; ++order)
        CHECK(differing(picture, panel(scene, order, 4, 2), panel(scene, 6, 4, 2)) > 20);
    CHECK(differing(picture, panel(scene, 7, 4, 2), panel(scene, 6, 4, 2)) == 0);
}

TEST_CASE("blending depends on the order of submission") {
    const Picture picture = draw_offscreen(program("T20"), false);
    const Scene scene{};
    CHECK(differing(picture, panel(scene, 0, 2, 2), panel(scene, 1, 2, 2)) > 1000);
    CHECK(differing(picture, panel(scene, 1, 2, 2), panel(scene, 2, 2, 2)) > 1000);
}

} // namespace
} // namespace ffgpu::gallery
