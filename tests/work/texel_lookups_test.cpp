// The lines that a quad's textures look up, against the line of each single texel.

#include "model/work/texel_lookups.h"

#include <algorithm>
#include <random>

#include <catch2/catch.hpp>

namespace ffgpu::work {
namespace {

constexpr std::uint16_t Border = TexelAccess::BorderTexel;

PlacedLevel random_level(std::mt19937& random) {
    const auto layout = static_cast<Layout>(random() % 3);
    PlacedLevel level;
    level.layout = ImageLayout::make(layout, 1u << random() % 4, 8, 16, 16, 1u << random() % 5);
    level.base = 64 * (random() % 64);
    if (random() % 4 == 0) level.block_width = level.block_height = 2; // texels of an element
    level.layer_bytes = level.layout.bytes();
    return level;
}

TexelAccess random_access(std::mt19937& random, std::uint16_t lane) {
    const auto below_16 = [&] { return static_cast<std::uint16_t>(random() % 16); };
    TexelAccess access{.lane = lane,
                       .level = 0,
                       .linear = static_cast<std::uint8_t>(random() % 2 == 0 ? 3 : random() % 8),
                       .x0 = below_16(),
                       .x1 = below_16(),
                       .y0 = below_16(),
                       .y1 = below_16(),
                       .layer0 = static_cast<std::uint16_t>(random() % 3),
                       .layer1 = static_cast<std::uint16_t>(random() % 3)};
    if (random() % 2 == 0) { // neighbours, as filters mostly have them
        access.x1 = static_cast<std::uint16_t>((access.x0 + 1) % 16);
        access.y1 = static_cast<std::uint16_t>((access.y0 + 1) % 16);
    }
    if (random() % 8 == 0) (random() % 2 == 0 ? access.x1 : access.y0) = Border;
    return access;
}

struct Read {
    std::vector<std::uint64_t> lines;
    std::uint16_t texels = 0;
};

// Texel by texel, in the order of the corners.
void read(const PlacedLevel& level, const TexelAccess& access, std::uint32_t line_bytes, Read& to) {
    for (unsigned corner = 0; corner < 8; ++corner) {
        if ((corner & ~unsigned{access.linear}) != 0) continue;
        const std::uint16_t x = corner & 1 ? access.x1 : access.x0;
        const std::uint16_t y = corner & 2 ? access.y1 : access.y0;
        const std::uint16_t layer = corner & 4 ? access.layer1 : access.layer0;
        if (x == Border || y == Border) continue;
        ++to.texels;
        const std::uint64_t line = level.line(x, y, layer, line_bytes);
        if (std::find(to.lines.begin(), to.lines.end(), line) == to.lines.end())
            to.lines.push_back(line);
    }
}

TEST_CASE("a quad looks up the lines of its texels, each once, in the order of the reads") {
    std::mt19937 random(5);
    std::size_t several = 0;
    for (int run = 0; run < 4000; ++run) {
        const PlacedLevel level = random_level(random);
        WorkConfig config;
        config.texel_cache.line_bytes = 16u << random() % 4;
        WholeCommand command;
        command.units = {0};
        command.quads.resize(1);
        Read expected;
        for (int lane = 0; lane < 1 + run % 4; ++lane) {
            const TexelAccess access = random_access(random, static_cast<std::uint16_t>(lane));
            command.add_access(0, access);
            read(level, access, config.texel_cache.line_bytes, expected);
        }

        PreparedQuads made;
        PreparedQuad quad;
        TexelLookups lookups(command, config);
        const auto texture = std::make_shared<TextureLines>();
        texture->add(level, config.texel_cache.line_bytes);
        lookups.place(0, texture);
        lookups.add(0, 0xf, quad, made);
        REQUIRE(made.texel_lines == expected.lines);
        REQUIRE(quad.texel_line_count == expected.lines.size());
        REQUIRE(quad.texel_reads == expected.texels);
        several += expected.lines.size() > 1;
    }
    CHECK(several > 1000);
    CHECK(several < 4000);
}

} // namespace
} // namespace ffgpu::work
