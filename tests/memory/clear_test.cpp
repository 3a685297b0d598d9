#include "model/memory/clear.h"
#include "model/memory/pixel_format.h"

#include <vector>

#include <catch2/catch.hpp>

using namespace ffgpu;

namespace {

constexpr std::uint32_t Old = 0x5a6b7c8d;

struct ClearBench {
    std::vector<std::byte> memory = std::vector<std::byte>(16384);
    Registers registers;
    ClearCommand clear;
    Rectangle rectangle{2, 1, 7, 5};

    ClearBench() {
        for (std::size_t i = 0; i < memory.size(); i += 4)
            store_word(memory.data() + i, Old);
        registers.targets.color[0] = surface(1024, Format::Rgba8);
        registers.targets.depth = surface(4096, Format::Depth24Stencil8);
    }

    static Surface surface(DeviceAddress address, Format format) {
        return {.address = address,
                .format = format,
                .width = 10,
                .height = 8,
                .stride = 11u * format_info(format).block_bytes};
    }

    // Runs the clear and requires that exactly the rectangle's pixels hold `expected(x, y)`.
    template <class Word, class Expected>
    void require_pixels(const Surface& target, Expected&& expected) {
        std::vector<std::byte> wanted = memory;
        for (int y = rectangle.y0; y < rectangle.y1; ++y)
            for (int x = rectangle.x0; x < rectangle.x1; ++x)
                store_word(pixel_address(target,
                                         wanted,
                                         static_cast<std::uint32_t>(x),
                                         static_cast<std::uint32_t>(y)),
                           static_cast<Word>(expected(x, y)));
        clear_rectangle(clear, registers, rectangle, memory);
        REQUIRE((memory == wanted));
    }
};

} // namespace

TEST_CASE("A colour clear fills the rectangle and no other byte") {
    ClearBench bench;
    bench.clear = {.color = true, .color_value = 0x11223344};
    bench.require_pixels<std::uint32_t>(bench.registers.targets.color[0],
                                        [](int, int) { return 0x11223344u; });
}

TEST_CASE("The colour write mask keeps the channels that are off, for each of the 16 masks") {
    for (std::uint8_t mask = 0; mask < 16; ++mask) {
        ClearBench bench;
        bench.registers.blend.write_mask = mask;
        bench.clear = {.color = true, .color_value = 0x11223344};
        std::uint32_t bits = 0;
        for (unsigned i = 0; i < 4; ++i)
            if ((mask >> i & 1) != 0) bits |= 0xffu << 8 * i;
        bench.require_pixels<std::uint32_t>(bench.registers.targets.color[0], [&](int, int) {
            return (0x11223344u & bits) | (Old & ~bits);
        });
    }
}

TEST_CASE("Rgbx8 stores 255 as its fourth byte whatever the mask") {
    ClearBench bench;
    bench.registers.targets.color[0].format = Format::Rgbx8;
    bench.registers.blend.write_mask = 0x1;
    bench.clear = {.color = true, .color_value = 0x11223344};
    bench.require_pixels<std::uint32_t>(bench.registers.targets.color[0], [](int, int) {
        return 0xff000000u | (Old & 0x00ffff00u) | 0x44u;
    });
}

// What a pixel holds after a clear, channel by channel: the specification of the fill of words.
std::uint32_t cleared_pixel(const Registers& registers, std::uint32_t stored, int x, int y) {
    constexpr std::uint32_t Color = 0xb1818243;
    const Format format = registers.targets.color[0].format;
    const Dithered dithered{
        bayer_threshold(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y))};
    const std::uint32_t written =
        unpack_pixel(format,
                     registers.fragment.dither ? pack_pixel(format, Color, dithered)
                                               : pack_pixel(format, Color));
    std::uint32_t color = unpack_pixel(format, stored);
    for (unsigned i = 0; i < 4; ++i) {
        const std::uint32_t byte = 0xffu << 8 * i;
        if ((registers.blend.write_mask >> i & 1) != 0) color = (color & ~byte) | (written & byte);
    }
    return pack_pixel(format, color);
}

template <class Word>
void check_clear(ClearBench& bench, Format format) {
    bench.registers.targets.color[0] = ClearBench::surface(1024, format);
    bench.clear = {.color = true, .color_value = 0xb1818243};
    const std::vector<std::byte> before = bench.memory;
    const auto at = [&](int x, int y) {
        return pixel_address(bench.registers.targets.color[0],
                             bench.memory,
                             static_cast<std::uint32_t>(x),
                             static_cast<std::uint32_t>(y));
    };
    bench.require_pixels<Word>(bench.registers.targets.color[0], [&](int x, int y) {
        const Word stored = load_word<Word>(before.data() + (at(x, y) - bench.memory.data()));
        return static_cast<Word>(cleared_pixel(bench.registers, stored, x, y));
    });
}

TEST_CASE("Every narrow and small format is cleared under the mask, dithered if the draw is") {
    for (const bool dithered : {false, true}) {
        for (std::uint8_t mask = 0; mask < 16; ++mask) {
            const auto bench = [&] {
                ClearBench made;
                made.registers.fragment.dither = dithered;
                made.registers.blend.write_mask = mask;
                return made;
            };
            for (const Format format : {Format::Luminance8, Format::Alpha8, Format::Intensity8}) {
                ClearBench made = bench();
                check_clear<std::uint8_t>(made, format);
            }
            for (const Format format :
                 {Format::LuminanceAlpha8, Format::Rgb565, Format::Rgba4, Format::Rgb5a1}) {
                ClearBench made = bench();
                check_clear<std::uint16_t>(made, format);
            }
        }
    }
}

TEST_CASE("Depth and stencil are cleared apart and together, stencil under its mask") {
    ClearBench bench;
    const Surface& target = bench.registers.targets.depth;
    bench.registers.stencil.front.write_mask = 0x0f;
    SECTION("depth keeps stencil") {
        bench.clear = {.depth = true, .stencil_value = 0xff, .depth_value = 0x123456};
        bench.require_pixels<std::uint32_t>(target,
                                            [](int, int) { return 0x12345600u | (Old & 0xff); });
    }
    SECTION("stencil keeps depth and what is masked") {
        bench.clear = {.stencil = true, .stencil_value = 0xa5, .depth_value = 0x123456};
        bench.require_pixels<std::uint32_t>(target,
                                            [](int, int) { return (Old & ~0x0fu) | 0x05u; });
    }
    SECTION("both") {
        bench.clear = {
            .depth = true, .stencil = true, .stencil_value = 0xa5, .depth_value = 0x123456};
        bench.require_pixels<std::uint32_t>(
            target, [](int, int) { return 0x12345600u | (Old & 0xf0u) | 0x05u; });
    }
    SECTION("a stencil mask of nothing") {
        bench.registers.stencil.front.write_mask = 0;
        bench.clear = {.stencil = true, .stencil_value = 0xa5};
        bench.require_pixels<std::uint32_t>(target, [](int, int) { return Old; });
    }
}

TEST_CASE("Depth16 takes the depth and has no stencil") {
    ClearBench bench;
    bench.registers.targets.depth = ClearBench::surface(4096, Format::Depth16);
    bench.clear = {.depth = true, .stencil = true, .stencil_value = 1, .depth_value = 0xfedc};
    bench.require_pixels<std::uint16_t>(bench.registers.targets.depth,
                                        [](int, int) { return 0xfedc; });
}

TEST_CASE("Every colour target is cleared") {
    ClearBench bench;
    bench.registers.targets.color[3] = ClearBench::surface(8192, Format::Rgba8);
    bench.clear = {.color = true, .color_value = 0x01020304};
    clear_rectangle(bench.clear, bench.registers, bench.rectangle, bench.memory);
    for (const Surface* target :
         {&bench.registers.targets.color[0], &bench.registers.targets.color[3]})
        REQUIRE(load_word<std::uint32_t>(pixel_address(*target, bench.memory, 3, 3)) == 0x01020304);
}

TEST_CASE("A clear beyond the target or of a target beyond memory touches nothing outside") {
    ClearBench bench;
    bench.clear = {.color = true, .depth = true, .color_value = 1, .depth_value = 1};
    const std::vector<std::byte> before = bench.memory;
    SECTION("outside") {
        bench.rectangle = {10, 8, 20, 20};
    }
    SECTION("beyond memory") {
        bench.registers.targets.color[0].address = 16384 - 8;
        bench.registers.targets.depth.address = 0xfffffff0;
    }
    clear_rectangle(bench.clear, bench.registers, bench.rectangle, bench.memory);
    REQUIRE((bench.memory == before));
}

TEST_CASE("A clear fills every sample of multisampled targets") {
    ClearBench bench;
    bench.clear = {
        .color = true, .depth = true, .color_value = 0x11223344, .depth_value = 0x555555};
    Surface& color = bench.registers.targets.color[0];
    Surface& depth = bench.registers.targets.depth;
    color.samples = depth.samples = MaxSamples;
    bench.registers.stencil.front.write_mask = 0;
    std::vector<std::byte> wanted = bench.memory;
    for (unsigned i = 0; i < MaxSamples; ++i)
        for (std::uint32_t y = 1; y < 5; ++y)
            for (std::uint32_t x = 2; x < 7; ++x) {
                store_word(pixel_address(color.plane(i), wanted, x, y), 0x11223344u);
                store_word(pixel_address(depth.plane(i), wanted, x, y), 0x55555500u | (Old & 255));
            }
    clear_rectangle(bench.clear, bench.registers, bench.rectangle, bench.memory);
    REQUIRE((bench.memory == wanted));
}

TEST_CASE("A multisampled target whose last sample leaves memory is left alone") {
    ClearBench bench;
    bench.clear = {.color = true, .color_value = 0x11223344};
    Surface& color = bench.registers.targets.color[0];
    color.samples = MaxSamples;
    color.address = static_cast<DeviceAddress>(bench.memory.size() - color.bytes() + color.stride);
    const std::vector<std::byte> before = bench.memory;
    clear_rectangle(bench.clear, bench.registers, bench.rectangle, bench.memory);
    REQUIRE((bench.memory == before));
}
