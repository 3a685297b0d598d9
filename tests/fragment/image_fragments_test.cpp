#include "model/memory/pixel_format.h"
#include "model/raster/image_fragments.h"

#include <cmath>
#include <limits>
#include <map>
#include <vector>

#include <catch2/catch.hpp>

using namespace ffgpu;

namespace {

using Pixel = std::pair<int, int>;

struct Fragment {
    PixelColor color;
    std::uint32_t depth;
};

struct ImageBench {
    std::vector<std::byte> memory = std::vector<std::byte>(1u << 16);
    std::shared_ptr<Registers> registers = std::make_shared<Registers>();
    DrawImageCommand image;
    Rectangle tile{0, 0, 64, 64};
    unsigned batches = 0;

    // An Rgba8 image whose pixel (i, j) has red i and green j.
    ImageBench(unsigned width, unsigned height) {
        registers->targets.depth.format = Format::Depth24Stencil8;
        image.format = Format::Rgba8;
        image.address = 256;
        image.stride = width * 4;
        image.width = width;
        image.height = height;
        for (unsigned j = 0; j < height; ++j)
            for (unsigned i = 0; i < width; ++i)
                store_word(memory.data() + 256 + j * image.stride + 4 * i, i | j << 8);
    }

    std::map<Pixel, Fragment> draw() {
        DrawState state;
        state.registers = registers;
        std::map<Pixel, Fragment> fragments;
        batches = 0;
        image_fragments(image, state, tile, memory, [&](FragmentBatch& batch) {
            ++batches;
            REQUIRE(batch.quad_count > 0);
            REQUIRE(batch.quad_count <= BatchQuads);
            for (unsigned lane = 0; lane < BatchFragments; ++lane) {
                if (!batch.live.test(lane)) continue;
                REQUIRE(lane < batch.lanes());
                const unsigned q = lane / 4;
                REQUIRE(batch.x[q] % 2 + batch.y[q] % 2 == 0);
                const Pixel at{batch.x[q] + int(lane & 1), batch.y[q] + int(lane >> 1 & 1)};
                const auto byte = [](std::uint16_t v) { return static_cast<std::uint8_t>(v); };
                const bool first = fragments
                                       .insert({at,
                                                {{byte(batch.primary.r[lane]),
                                                  byte(batch.primary.g[lane]),
                                                  byte(batch.primary.b[lane]),
                                                  byte(batch.primary.a[lane])},
                                                 batch.depth[lane]}})
                                       .second;
                REQUIRE(first);
            }
            batch.color = batch.primary; // What a sink may do to its batch,
            batch.live = {};             // and what must not show in the next one.
        });
        return fragments;
    }
};

// Pixel (i, j) covers the centres in its zoomed rectangle, left and lower edge included.
std::map<Pixel, Pixel> expected_placement(const DrawImageCommand& image, Rectangle tile) {
    std::map<Pixel, Pixel> sources;
    for (int y = tile.y0; y < tile.y1; ++y)
        for (int x = tile.x0; x < tile.x1; ++x)
            for (unsigned j = 0; j < image.height; ++j)
                for (unsigned i = 0; i < image.width; ++i) {
                    const auto holds = [](double origin, double zoom, unsigned k, int at) {
                        const double a = origin + zoom * k, b = origin + zoom * (k + 1);
                        return std::min(a, b) <= at + 0.5 && at + 0.5 < std::max(a, b);
                    };
                    if (holds(image.x, image.zoom_x, i, x) && holds(image.y, image.zoom_y, j, y))
                        sources[{x, y}] = {static_cast<int>(i), static_cast<int>(j)};
                }
    return sources;
}

void require_placement(ImageBench& bench) {
    const std::map<Pixel, Fragment> fragments = bench.draw();
    const std::map<Pixel, Pixel> expected = expected_placement(bench.image, bench.tile);
    REQUIRE(fragments.size() == expected.size());
    for (const auto& [at, source] : expected) {
        INFO(at.first << ", " << at.second);
        REQUIRE(fragments.count(at) == 1);
        REQUIRE(int(fragments.at(at).color[0]) == source.first);
        REQUIRE(int(fragments.at(at).color[1]) == source.second);
    }
}

} // namespace

TEST_CASE("An image at a whole position covers its pixels, one fragment each") {
    ImageBench bench(7, 5);
    bench.image.x = 3;
    bench.image.y = 2;
    const auto fragments = bench.draw();
    REQUIRE(fragments.size() == 35);
    REQUIRE(fragments.at({3, 2}).color == PixelColor{0, 0, 0, 0});
    REQUIRE(fragments.at({9, 6}).color == PixelColor{6, 4, 0, 0});
    require_placement(bench);
}

TEST_CASE("Zoom, whole, fractional and negative, places fragments by their centres") {
    for (const float zoom_x : {1.0f, 2.0f, 2.5f, 0.5f, 0.25f, -1.0f, -2.0f, -1.75f, -0.5f, 1.25f})
        for (const float zoom_y : {1.0f, -3.0f, 0.75f, -0.5f})
            for (const float x : {0.0f, 20.0f, 20.5f, 20.25f, 63.0f, -4.5f}) {
                INFO("zoom " << zoom_x << " " << zoom_y << " x " << x);
                ImageBench bench(9, 6);
                bench.image.x = x;
                bench.image.y = 21.5f;
                bench.image.zoom_x = zoom_x;
                bench.image.zoom_y = zoom_y;
                require_placement(bench);
            }
}

TEST_CASE("A centre on an edge belongs to the pixel whose left or lower edge it is") {
    ImageBench bench(2, 1);
    bench.image.x = 4.5f; // Edges at 4.5, 5.5, 6.5: centres of pixels 4, 5, 6.
    bench.image.y = 0;
    const auto right = bench.draw();
    REQUIRE(right.size() == 2);
    REQUIRE(int(right.at({4, 0}).color[0]) == 0);
    REQUIRE(int(right.at({5, 0}).color[0]) == 1);

    bench.image.x = 6.5f;
    bench.image.zoom_x = -1; // The same edges, from the right.
    const auto left = bench.draw();
    REQUIRE(left.size() == 2);
    REQUIRE(int(left.at({4, 0}).color[0]) == 1);
    REQUIRE(int(left.at({5, 0}).color[0]) == 0);
}

TEST_CASE("A tile gets its part of an image, whatever the tile's corner") {
    ImageBench bench(20, 20);
    bench.image.x = 1;
    bench.image.y = 1;
    bench.image.zoom_x = 1.5f;
    for (const Rectangle tile :
         {Rectangle{5, 3, 12, 9}, {0, 0, 1, 1}, {1, 1, 2, 2}, {29, 17, 64, 64}}) {
        bench.tile = tile;
        require_placement(bench);
    }
}

TEST_CASE("The parts of all tiles are the whole image") {
    ImageBench bench(50, 40);
    bench.image.x = 2.25f;
    bench.image.zoom_y = -1.1f;
    bench.image.y = 47.3f;
    const auto whole = bench.draw();
    REQUIRE(bench.batches > 1);
    std::size_t parts = 0;
    for (int y = 0; y < 64; y += 16)
        for (int x = 0; x < 64; x += 32) {
            bench.tile = {x, y, x + 32, y + 16};
            for (const auto& [at, fragment] : bench.draw()) {
                REQUIRE(whole.at(at).color == fragment.color);
                ++parts;
            }
        }
    REQUIRE(parts == whole.size());
}

TEST_CASE("A bitmap makes fragments of the constant colour where its bits are set") {
    ImageBench bench(11, 3);
    bench.image.format = Format::Bitmap;
    bench.image.stride = 2;
    bench.image.color = {1.0f, 0.5f, 0.0f, 2.0f};
    bench.image.depth = 0.5f;
    const std::uint8_t rows[] = {0b00000001, 0b100, 0b10000000, 0b000, 0, 0b001};
    std::memcpy(bench.memory.data() + 256, rows, sizeof rows);
    const auto fragments = bench.draw();
    REQUIRE(fragments.size() == 4);
    for (const Pixel& at : {Pixel{0, 0}, {10, 0}, {7, 1}, {8, 2}}) {
        REQUIRE(fragments.at(at).color == PixelColor{255, 128, 0, 255});
        REQUIRE(fragments.at(at).depth == 0x800000);
    }
}

TEST_CASE("A depth image gives its depths in the units of the target") {
    ImageBench bench(2, 1);
    bench.image.format = Format::Depth24Stencil8;
    bench.image.color = {0, 1, 0, 1};
    store_word(bench.memory.data() + 256, std::uint32_t{0x12345677});
    store_word(bench.memory.data() + 260, std::uint32_t{0xffffff00});
    REQUIRE(bench.draw().at({0, 0}).depth == 0x123456);
    REQUIRE(bench.draw().at({1, 0}).depth == 0xffffff);
    REQUIRE(bench.draw().at({0, 0}).color == PixelColor{0, 255, 0, 255});
    bench.registers->targets.depth.format = Format::Depth16;
    REQUIRE(bench.draw().at({0, 0}).depth == 0x1234);
    REQUIRE(bench.draw().at({1, 0}).depth == 0xffff);
}

TEST_CASE("Images that leave memory or have no extent make no fragment") {
    ImageBench bench(4, 4);
    REQUIRE(bench.draw().size() == 16);
    SECTION("one byte beyond memory") {
        bench.image.address = static_cast<DeviceAddress>(bench.memory.size() - 63);
    }
    SECTION("a stride beyond memory") {
        bench.image.stride = 0xffffffff;
    }
    SECTION("a wild width") {
        bench.image.width = 0xffffffff;
    }
    SECTION("a wild height") {
        bench.image.height = 0xffffffff;
    }
    SECTION("no width") {
        bench.image.width = 0;
    }
    SECTION("zoom zero") {
        bench.image.zoom_x = 0;
    }
    SECTION("zoom not a number") {
        bench.image.zoom_y = std::numeric_limits<float>::quiet_NaN();
    }
    SECTION("an infinite position") {
        bench.image.x = std::numeric_limits<float>::infinity();
    }
    SECTION("another format") {
        bench.image.format = Format::Luminance8;
    }
    SECTION("an empty tile") {
        bench.tile = {5, 5, 5, 9};
    }
    REQUIRE(bench.draw().empty());
}

TEST_CASE("Extreme zooms neither overflow nor hang") {
    ImageBench bench(4, 4);
    bench.image.zoom_x = 3e38f;
    bench.image.x = -1;
    REQUIRE(bench.draw().size() == 64 * 4);
    bench.image.zoom_x = 1e-38f;
    REQUIRE(bench.draw().empty());
    bench.image.zoom_x = -3e38f;
    bench.image.x = 3e38f;
    REQUIRE(bench.draw().size() == 64 * 4);
}

TEST_CASE("A stencil image writes stencil bits under the mask and nothing else") {
    ImageBench bench(3, 2);
    Registers& registers = *bench.registers;
    registers.targets.depth = {
        .address = 4096, .format = Format::Depth24Stencil8, .width = 8, .height = 8, .stride = 32};
    registers.stencil.front.write_mask = 0x0f;
    bench.image.format = Format::Stencil8;
    bench.image.stride = 3;
    bench.image.x = 6;
    bench.image.y = 2;
    for (unsigned i = 0; i < 6; ++i)
        store_word(bench.memory.data() + 256 + i, static_cast<std::uint8_t>(0xa1 + i));
    for (unsigned i = 0; i < 64; ++i)
        store_word(bench.memory.data() + 4096 + 4 * i, std::uint32_t{0x12345670});
    std::vector<std::byte> expected = bench.memory;
    for (const auto [x, y, value] :
         {std::array{6u, 2u, 1u}, {7u, 2u, 2u}, {6u, 3u, 4u}, {7u, 3u, 5u}})
        store_word(expected.data() + 4096 + y * 32 + x * 4, 0x12345670u | value);
    draw_stencil_image(bench.image, registers, bench.tile, bench.memory);
    REQUIRE((bench.memory == expected)); // The third column lies outside the target.
    REQUIRE(bench.draw().empty());       // and makes no fragments
}
