// The bytes of each line that a cleared rectangle writes, against the bytes of each single pixel.

#include "model/work/surface_lines.h"

#include <map>
#include <random>
#include <set>

#include <catch2/catch.hpp>

namespace ffgpu::work {
namespace {

struct Case {
    PlacedLevel place;
    std::uint32_t line_bytes = 64;
    Rectangle rectangle;
};

Case random_case(std::mt19937& random) {
    Case it;
    const std::uint32_t block = 2u << random() % 3, superblock = 16;
    // Whole blocks, or a few pixels more.
    const auto size = [&] {
        const std::uint32_t more = static_cast<std::uint32_t>(random() % 2 * (random() % 9));
        return static_cast<std::uint32_t>(16 * (1 + random() % 3) + more);
    };
    it.place.layout =
        ImageLayout::make(static_cast<Layout>(random() % 3), block, superblock, size(), size(), 4);
    it.place.base = 64 * (random() % 9);
    it.line_bytes = 16u << random() % 6;
    const int width = static_cast<int>(it.place.layout.width);
    const int height = static_cast<int>(it.place.layout.height);
    it.rectangle = {0, 0, width, height};
    if (random() % 2 == 0) it.rectangle = {3, 2, width - 4, height};
    return it;
}

// Bytes of memory that the rectangle's pixels have.
std::set<std::uint64_t> bytes_of(const Case& it) {
    std::set<std::uint64_t> bytes;
    const Rectangle& r = it.rectangle;
    for (int y = r.y0; y < r.y1; ++y)
        for (int x = r.x0; x < r.x1; ++x)
            for (std::uint32_t i = 0; i < it.place.layout.element_bytes; ++i)
                bytes.insert(it.place.address(
                                 static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), 0) +
                             i);
    return bytes;
}

TEST_CASE("a cleared rectangle writes of each line the bytes of its pixels") {
    std::mt19937 random(11);
    std::size_t whole = 0;
    for (int run = 0; run < 300; ++run) {
        const Case it = random_case(random);
        const LineGrain grain(it.line_bytes);
        // Of each line the written bytes of each bit.
        std::map<std::uint64_t, std::map<std::uint32_t, std::uint32_t>> expected;
        PixelBytes pixel = whole_pixel(Format::Rgba8); // or some of its bytes
        if (run % 2 != 0) {
            pixel.touched = 1 + static_cast<std::uint32_t>(random()) % 15;
            pixel.covered = pixel.touched & static_cast<std::uint32_t>(random());
        }
        for (const std::uint64_t byte : bytes_of(it)) {
            const std::uint64_t of_pixel = (byte - it.place.base) % 4;
            if ((pixel.touched >> of_pixel & 1) == 0) continue;
            expected[byte / it.line_bytes][static_cast<std::uint32_t>(byte % it.line_bytes) /
                                           grain.bytes()] += pixel.covered >> of_pixel & 1;
        }
        const auto lines = rectangle_lines(it.place, grain, it.rectangle, pixel);
        CAPTURE(run, it.line_bytes);
        REQUIRE(lines.size() == expected.size());
        auto line = lines.begin();
        for (const auto& [number, bits] : expected) {
            WrittenBytes bytes;
            for (const auto& [bit, count] : bits) {
                bytes.touched |= LineMask{1} << bit;
                if (count == grain.bytes()) bytes.covered |= LineMask{1} << bit;
            }
            REQUIRE(line->number == number);
            REQUIRE(line->bytes == bytes);
            whole += bytes.covered == grain.all();
            ++line;
        }
    }
    CHECK(whole > 1000);
}

} // namespace
} // namespace ffgpu::work
