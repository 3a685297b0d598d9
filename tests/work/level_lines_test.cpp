// The rectangles of texels that lie on one line, against the texels' addresses.

#include "model/work/level_lines.h"

#include <map>
#include <random>

#include <catch2/catch.hpp>

namespace ffgpu::work {
namespace {

PlacedLevel level_of(Layout layout,
                     std::uint32_t width,
                     std::uint32_t height,
                     std::uint32_t bytes,
                     std::uint64_t at) {
    return {.layout = ImageLayout::make(layout, 4, 32, width, height, bytes),
            .base = at,
            .layer_bytes = std::uint64_t{width} * height * bytes};
}

LevelLines::Rectangles rectangle_of(const LevelLines& lines, std::uint32_t x, std::uint32_t y) {
    TexelAccess access{};
    access.x0 = access.x1 = static_cast<std::uint16_t>(x);
    access.y0 = access.y1 = static_cast<std::uint16_t>(y);
    return lines.rectangles(access);
}

std::uint32_t key_of(const LevelLines::Rectangles& rectangles) {
    return std::uint32_t{rectangles.y0} << 16 | rectangles.x0;
}

} // namespace

TEST_CASE("texels of one rectangle are of one line", "[curves]") {
    std::mt19937 generator(5);
    const auto random = [&] { return static_cast<std::uint32_t>(generator()); };
    for (const Layout layout : {Layout::Linear, Layout::Blocked, Layout::Blocked6d})
        for (int i = 0; i < 60; ++i) {
            const std::uint32_t line_bytes = 16u << random() % 5, bytes = 1u << random() % 3;
            const PlacedLevel level = level_of(
                layout, 1 + random() % 70, 1 + random() % 70, bytes, random() % 8 * 64 + 4096);
            const LevelLines lines(level, line_bytes);
            std::map<std::uint32_t, std::uint64_t> line_of;
            for (std::uint32_t y = 0; y < level.layout.height; ++y)
                for (std::uint32_t x = 0; x < level.layout.width; ++x) {
                    const std::uint64_t line = level.address(x, y, 0) / line_bytes;
                    const auto rectangle = rectangle_of(lines, x, y);
                    REQUIRE(rectangle.are_one());
                    REQUIRE(line_of.try_emplace(key_of(rectangle), line).first->second == line);
                }
        }
}

// 64 bytes are 16 texels of 4 bytes: a row, or a block; 128 are two blocks beside each other.
TEST_CASE("rectangles are as large as a line's texels", "[curves]") {
    const auto size = [](Layout layout, std::uint32_t line_bytes) {
        const LevelLines lines(level_of(layout, 64, 64, 4, 8192), line_bytes);
        std::uint32_t width = 1, height = 1;
        while (rectangle_of(lines, width, 0) == rectangle_of(lines, 0, 0))
            ++width;
        while (rectangle_of(lines, 0, height) == rectangle_of(lines, 0, 0))
            ++height;
        return std::pair(width, height);
    };
    CHECK(size(Layout::Linear, 64) == std::pair(16u, 1u));
    CHECK(size(Layout::Linear, 16) == std::pair(4u, 1u));
    CHECK(size(Layout::Blocked, 64) == std::pair(4u, 4u));
    CHECK(size(Layout::Blocked, 32) == std::pair(4u, 2u));
    CHECK(size(Layout::Blocked, 128) == std::pair(8u, 4u));
    CHECK(size(Layout::Blocked6d, 64) == std::pair(4u, 4u));
    CHECK(size(Layout::Blocked6d, 1024) == std::pair(32u, 8u));
}

} // namespace ffgpu::work
