// The fragment pipe in RTL against the model where a depth lies exactly between two stored ones,
// and the lowest bit of its plane's origin says which: one fragment of 2^25 does, so they are
// looked for.

#include "tests/gpu/scene.h"
#include "tests/raster/raster_helpers.h"
#include "tools/rtl/pipe_comparison.h"

#include <optional>
#include <random>

#include <catch2/catch.hpp>

namespace ffgpu::tools {
namespace {

constexpr int Size = 64;
using Corners = std::array<std::array<int, 3>, 3>; // x and y in 1/256 pixel, z in 2^-21

// Window coordinates that both ways to set-up have without rounding.
test::Vertex in_clip_space(const std::array<int, 3>& corner) {
    const auto clip = [](int at, float all) { return static_cast<float>(at) / all * 2 - 1; };
    constexpr float Width = Size * 256, Deep = 1 << 21;
    return {
        clip(corner[0], Width), clip(corner[1], Width), clip(corner[2], Deep), 1, 1, 1, 1, 1, 0, 0};
}

struct Tie {
    test::Pixel pixel;
    std::uint32_t depth; // to nearest, up
};

// A covered pixel whose depth would be rounded down if the origin's lowest bit were lost.
std::optional<Tie> tie_of(const SetupRecord& record) {
    const DepthPlane& plane = record.depth;
    constexpr std::int64_t One = std::int64_t{1} << DepthPlane::FractionBits;
    if (plane.origin % 2 == 0) return {};
    for (int y = record.box.y0; y < record.box.y1; ++y)
        for (int x = record.box.x0; x < record.box.x1; ++x) {
            const std::int64_t depth = plane.at(x - record.x_reference, y - record.y_reference);
            if ((depth & (One - 1)) == One / 2 && test::covered_pixels(record).contains({x, y}))
                return Tie{{x, y}, static_cast<std::uint32_t>(depth / One + 1)};
        }
    return {};
}

TEST_CASE("Depths half way between two are rounded up by the lowest bit of a plane's origin") {
    PipeComparison comparison(rtl::PipeOptions{});
    test::Scene scene(Size, Size);
    comparison.attach(scene.gpu, scene.gpu);
    scene.into = &comparison;

    scene.registers.depth = {.test_enable = true, .write_enable = true, .compare = Compare::Always};
    std::mt19937 random(5);
    test::RecordBuffer buffer;
    const SetupContext context = test::context({0, 0, Size, Size});
    for (int found = 0; found < 2;) {
        Corners corners;
        for (auto& [x, y, z] : corners) {
            x = static_cast<int>(random() % (Size * 256));
            y = static_cast<int>(random() % (Size * 256));
            z = static_cast<int>(random() % (1 << 21));
        }
        std::array<WindowVertex, 3> window;
        for (unsigned i = 0; i < 3; ++i)
            window[i] = test::vertex(
                corners[i][0], corners[i][1], static_cast<float>(corners[i][2]) / (1 << 21));
        if (!buffer.triangle(context, window[0], window[1], window[2])) continue;
        const std::optional<Tie> tie = tie_of(buffer.record());
        if (!tie) continue;
        ++found;
        scene.clear(0);
        scene.draw(
            PrimitiveType::Triangles,
            {in_clip_space(corners[0]), in_clip_space(corners[1]), in_clip_space(corners[2])});
        const auto at = static_cast<std::size_t>(tie->pixel.second * Size + tie->pixel.first);
        CHECK(scene.depth_buffer()[at] >> 8 == tie->depth);
        INFO(comparison.summary());
        CHECK(comparison.equal());
    }
}

} // namespace
} // namespace ffgpu::tools
