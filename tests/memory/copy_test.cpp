#include "model/memory/copy.h"
#include "model/memory/pixel_format.h"

#include <array>
#include <random>
#include <vector>

#include <catch2/catch.hpp>

using namespace ffgpu;

namespace {

constexpr Format ColorFormats[] = {Format::Rgba8,
                                   Format::Rgbx8,
                                   Format::Luminance8,
                                   Format::Alpha8,
                                   Format::Intensity8,
                                   Format::LuminanceAlpha8,
                                   Format::Rgb565,
                                   Format::Rgba4,
                                   Format::Rgb5a1};

std::vector<std::byte> random_memory(std::uint32_t seed) {
    std::mt19937 generator(seed);
    std::vector<std::byte> memory(1u << 15);
    for (std::byte& byte : memory)
        byte = static_cast<std::byte>(generator() >> 7);
    return memory;
}

Surface surface(DeviceAddress address, Format format, std::uint16_t width, std::uint16_t height) {
    return {.address = address,
            .format = format,
            .width = width,
            .height = height,
            .stride = row_bytes(format, width) + 4};
}

// Pixel by pixel from a copy of memory: the result as if the source had been read first.
std::vector<std::byte> expected_copy(const CopyRectangleCommand& copy,
                                     const std::vector<std::byte>& memory) {
    std::vector<std::byte> source = memory, result = memory;
    for (unsigned y = 0; y < copy.height; ++y)
        for (unsigned x = 0; x < copy.width; ++x) {
            const std::byte* from =
                pixel_address(copy.source, source, copy.source_x + x, copy.source_y + y);
            std::byte* to = pixel_address(
                copy.destination, result, copy.destination_x + x, copy.destination_y + y);
            if (copy.source.format == copy.destination.format) {
                std::memcpy(to, from, format_info(copy.source.format).block_bytes);
            } else if (is_depth_target(copy.source.format)) {
                std::uint32_t depth;
                load_depth24(copy.source.format, from, std::span(&depth, 1));
                store_depth24(copy.destination.format, std::span(&depth, 1), to);
            } else {
                store_rgba8(copy.destination.format, load_rgba8(copy.source.format, from), to);
            }
        }
    return result;
}

void require_copy(const CopyRectangleCommand& copy) {
    std::vector<std::byte> memory = random_memory(copy.width);
    const std::vector<std::byte> expected = expected_copy(copy, memory);
    REQUIRE((memory != expected));
    copy_rectangle(copy, memory);
    REQUIRE((memory == expected));
}

} // namespace

TEST_CASE("Each colour format copies to each, pixel for pixel and nothing beside") {
    for (const Format from : ColorFormats)
        for (const Format to : ColorFormats) {
            INFO(format_info(from).name << " to " << format_info(to).name);
            require_copy({.source = surface(128, from, 31, 17),
                          .destination = surface(8192, to, 20, 19),
                          .source_x = 3,
                          .source_y = 1,
                          .destination_x = 5,
                          .destination_y = 4,
                          .width = 15,
                          .height = 14});
        }
}

TEST_CASE("Depth copies between its formats, and stencil bits go along or stay") {
    for (const Format from : {Format::Depth16, Format::Depth24Stencil8})
        for (const Format to : {Format::Depth16, Format::Depth24Stencil8})
            require_copy({.source = surface(128, from, 31, 17),
                          .destination = surface(8192, to, 31, 17),
                          .width = 31,
                          .height = 17});
}

TEST_CASE("Within one surface a copy reads its source first, in every direction of overlap") {
    const Surface one = surface(256, Format::Rgba8, 32, 32);
    for (int dy = -2; dy <= 2; ++dy)
        for (int dx = -2; dx <= 2; ++dx) {
            if (dx == 0 && dy == 0) continue;
            INFO(dx << ", " << dy);
            require_copy({.source = one,
                          .destination = one,
                          .source_x = 4,
                          .source_y = 4,
                          .destination_x = static_cast<std::uint16_t>(4 + dx),
                          .destination_y = static_cast<std::uint16_t>(4 + dy),
                          .width = 20,
                          .height = 20});
        }
}

TEST_CASE("Surfaces that share memory with another stride or format are copied as if read first") {
    require_copy({.source = surface(256, Format::Rgba8, 32, 32),
                  .destination = surface(300, Format::Rgba8, 20, 32),
                  .width = 20,
                  .height = 30});
    require_copy({.source = surface(256, Format::Luminance8, 32, 32),
                  .destination = surface(256, Format::Rgba8, 32, 32),
                  .width = 30,
                  .height = 30});
}

TEST_CASE("A copy onto itself changes nothing") {
    const Surface one = surface(256, Format::Rgba8, 32, 32);
    std::vector<std::byte> memory = random_memory(1);
    const std::vector<std::byte> before = memory;
    copy_rectangle({.source = one, .destination = one, .width = 32, .height = 32}, memory);
    REQUIRE((memory == before));
}

TEST_CASE("A copy that leaves its surfaces or memory, or mixes kinds, does nothing") {
    CopyRectangleCommand copy{.source = surface(256, Format::Rgba8, 16, 16),
                              .destination = surface(8192, Format::Rgba8, 16, 16),
                              .width = 16,
                              .height = 16};
    require_copy(copy);
    SECTION("source too small") {
        copy.source_x = 1;
    }
    SECTION("destination too small") {
        copy.destination_y = 1;
    }
    SECTION("coordinates that wrap") {
        copy.source_x = 0xffff;
        copy.width = 2;
    }
    SECTION("source beyond memory") {
        copy.source.address = 0xffffff00;
    }
    SECTION("destination beyond memory") {
        copy.destination.stride = 0x7fffffff;
    }
    SECTION("colour to depth") {
        copy.destination.format = Format::Depth24Stencil8;
    }
    SECTION("compressed") {
        copy.source.format = Format::Dxt5;
    }
    SECTION("no width") {
        copy.width = 0;
    }
    SECTION("a format beyond the list") {
        copy.source.format = static_cast<Format>(29);
    }
    std::vector<std::byte> memory = random_memory(2);
    const std::vector<std::byte> before = memory;
    copy_rectangle(copy, memory);
    REQUIRE((memory == before));
}

// --- Samples ------------------------------------------------------------------------------------

namespace {

Surface multisampled(DeviceAddress address, Format format) {
    Surface one = surface(address, format, 12, 10);
    one.samples = MaxSamples;
    return one;
}

std::uint32_t
color_at(const Surface& plane, std::vector<std::byte>& memory, unsigned x, unsigned y) {
    return load_rgba8(plane.format, pixel_address(plane, memory, x, y));
}

CopyRectangleCommand sample_copy(const Surface& from, const Surface& to) {
    return {.source = from,
            .destination = to,
            .source_x = 2,
            .source_y = 1,
            .destination_x = 3,
            .destination_y = 2,
            .width = 8,
            .height = 7};
}

} // namespace

TEST_CASE("The mean of four samples is rounded to nearest, channel by channel") {
    REQUIRE(mean_rgba8({0, 0, 0, 0}) == 0);
    REQUIRE(mean_rgba8({~0u, ~0u, ~0u, ~0u}) == ~0u);
    REQUIRE(mean_rgba8({0x01000000, 0, 0, 0}) == 0);
    REQUIRE(mean_rgba8({0x01000001, 0x01000001, 0, 0}) == 0x01000001);
    REQUIRE(mean_rgba8({0xff, 0xff00, 0xff0000, 0xff000000}) == 0x40404040);
    REQUIRE(mean_rgba8({0xff, 0xff, 0xff, 0}) == 0xbf);
}

TEST_CASE("Between surfaces of four samples each sample is copied") {
    std::vector<std::byte> memory = random_memory(21);
    std::vector<std::byte> expected = memory;
    const CopyRectangleCommand copy =
        sample_copy(multisampled(128, Format::Rgba8), multisampled(8192, Format::Rgb565));
    for (unsigned i = 0; i < MaxSamples; ++i) {
        CopyRectangleCommand one = copy;
        one.source = copy.source.plane(i);
        one.destination = copy.destination.plane(i);
        expected = expected_copy(one, expected);
    }
    copy_rectangle(copy, memory);
    REQUIRE((memory == expected));
}

TEST_CASE("From four samples to one colours are averaged") {
    for (const Format to : {Format::Rgba8, Format::Rgb565}) {
        std::vector<std::byte> memory = random_memory(22);
        std::vector<std::byte> expected = memory;
        const CopyRectangleCommand copy =
            sample_copy(multisampled(128, Format::Rgba8), surface(8192, to, 20, 12));
        for (unsigned y = 0; y < copy.height; ++y)
            for (unsigned x = 0; x < copy.width; ++x) {
                std::array<unsigned, 4> sums{2, 2, 2, 2};
                for (unsigned i = 0; i < MaxSamples; ++i) {
                    const PixelColor color =
                        unpack_rgba8(color_at(copy.source.plane(i), memory, 2 + x, 1 + y));
                    for (unsigned channel = 0; channel < 4; ++channel)
                        sums[channel] += color[channel];
                }
                PixelColor mean{};
                for (unsigned channel = 0; channel < 4; ++channel)
                    mean[channel] = static_cast<std::uint8_t>(sums[channel] / 4);
                store_rgba8(
                    to, pack_rgba8(mean), pixel_address(copy.destination, expected, 3 + x, 2 + y));
            }
        copy_rectangle(copy, memory);
        REQUIRE((memory == expected));
    }
}

TEST_CASE("From four samples to one depth and stencil are those of sample 0") {
    std::vector<std::byte> memory = random_memory(23);
    CopyRectangleCommand copy = sample_copy(multisampled(128, Format::Depth24Stencil8),
                                            surface(8192, Format::Depth24Stencil8, 20, 12));
    CopyRectangleCommand first = copy;
    first.source = copy.source.plane(0);
    const std::vector<std::byte> expected = expected_copy(first, memory);
    copy_rectangle(copy, memory);
    REQUIRE((memory == expected));
}

TEST_CASE("From one sample to four each sample gets the pixel") {
    std::vector<std::byte> memory = random_memory(24);
    std::vector<std::byte> expected = memory;
    const CopyRectangleCommand copy =
        sample_copy(surface(128, Format::Rgba8, 12, 10), multisampled(8192, Format::Rgba8));
    for (unsigned i = 0; i < MaxSamples; ++i) {
        CopyRectangleCommand one = copy;
        one.destination = copy.destination.plane(i);
        expected = expected_copy(one, expected);
    }
    copy_rectangle(copy, memory);
    REQUIRE((memory == expected));
}

TEST_CASE("Samples that meet in memory are copied as if read first") {
    std::vector<std::byte> memory = random_memory(25);
    const Surface from = multisampled(128, Format::Rgba8);
    Surface to = from; // Its plane 0 is the source's plane 1.
    to.address += static_cast<DeviceAddress>(from.plane_bytes());
    const std::vector<std::byte> before = memory;
    std::vector<std::byte> source = before;
    copy_rectangle(sample_copy(from, to), memory);
    for (unsigned i = 0; i < MaxSamples; ++i)
        REQUIRE(color_at(to.plane(i), memory, 3, 2) == color_at(from.plane(i), source, 2, 1));
}

TEST_CASE("Of several pictures colours are averaged, to nearest, halves up") {
    for (const unsigned pictures : {2u, 8u, 16u})
        for (const Format to : {Format::Rgba8, Format::Rgb565}) {
            std::vector<std::byte> memory = random_memory(26 + pictures);
            std::vector<std::byte> expected = memory;
            CopyRectangleCommand copy =
                sample_copy(surface(128, Format::Rgba8, 12, 10), surface(16384, to, 20, 12));
            copy.pictures = static_cast<std::uint8_t>(pictures);
            for (unsigned y = 0; y < copy.height; ++y)
                for (unsigned x = 0; x < copy.width; ++x) {
                    PixelColor mean{};
                    for (unsigned channel = 0; channel < 4; ++channel) {
                        double sum = 0;
                        for (unsigned i = 0; i < pictures; ++i)
                            sum += unpack_rgba8(
                                color_at(copy.source.plane(i), memory, 2 + x, 1 + y))[channel];
                        mean[channel] = static_cast<std::uint8_t>(sum / pictures + 0.5);
                    }
                    store_rgba8(to,
                                pack_rgba8(mean),
                                pixel_address(copy.destination, expected, 3 + x, 2 + y));
                }
            copy_rectangle(copy, memory);
            REQUIRE((memory == expected));
        }
    // Pictures that leave memory are none.
    std::vector<std::byte> memory = random_memory(50);
    const std::vector<std::byte> before = memory;
    CopyRectangleCommand copy =
        sample_copy(surface(128, Format::Rgba8, 12, 10), surface(16384, Format::Rgba8, 20, 12));
    copy.source.address = static_cast<DeviceAddress>(memory.size() - 2 * copy.source.bytes());
    copy.pictures = 4;
    copy_rectangle(copy, memory);
    REQUIRE((memory == before));
}
