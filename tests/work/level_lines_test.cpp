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
            const std::uint32_t most = i % 2 == 0 ? 70 : 5;
            const PlacedLevel level = level_of(layout,
                                               1 + random() % most,
                                               1 + random() % most,
                                               bytes,
                                               4096 + random() % 32 * (random() % 2 ? 64 : 4));
            const LevelLines lines(level, line_bytes);
            for (std::uint32_t layer = 0; layer < 3; ++layer) {
                std::map<std::uint32_t, std::uint64_t> line_of;
                for (std::uint32_t y = 0; y < level.layout.height; ++y)
                    for (std::uint32_t x = 0; x < level.layout.width; ++x) {
                        const std::uint64_t line = level.address(x, y, layer) / line_bytes;
                        const auto rectangle = rectangle_of(lines, x, y);
                        REQUIRE(rectangle.are_one());
                        REQUIRE(line_of.try_emplace(key_of(rectangle), line).first->second == line);
                    }
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

// Four layers of 16 bytes, each in a line; of 32 bytes in the middle of one some lie across two.
TEST_CASE("a level that lies inside of a line is one rectangle", "[curves]") {
    const LevelLines small(level_of(Layout::Linear, 2, 2, 4, 4096 + 16), 64);
    CHECK(rectangle_of(small, 0, 0) == rectangle_of(small, 1, 1));
    const LevelLines across(level_of(Layout::Linear, 4, 2, 4, 4096 + 16), 64);
    CHECK_FALSE(rectangle_of(across, 0, 0) == rectangle_of(across, 3, 1));
}

} // namespace ffgpu::work
