// The bytes of each line that a cleared rectangle, or a quad, writes, against the bytes of each
// single pixel.

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

// Byte i of memory, of which a quad writes some.
struct QuadBytes {
    std::set<std::uint64_t> touched, covered;
};

QuadBytes bytes_of(const PlacedLevel& place, const WrittenQuad& quad, PixelBytes bytes) {
    QuadBytes all;
    const std::uint32_t sample = place.layout.element_bytes / place.samples;
    for (unsigned lane = 0; lane < 4; ++lane)
        for (unsigned s = 0; s < place.samples; ++s) {
            const bool written = place.samples == 1 || (quad.samples >> (4 * lane + s) & 1) != 0;
            if ((quad.lanes >> lane & 1) == 0 || !written) continue;
            for (unsigned i = 0; i < sample; ++i) {
                const std::uint64_t at = quad.addresses[lane] + s * sample + i;
                if (bytes.touched >> i & 1) all.touched.insert(at);
                if (bytes.covered >> i & 1) all.covered.insert(at);
            }
        }
    return all;
}

TEST_CASE("a quad writes of a line the bytes of its written samples") {
    std::mt19937 random(12);
    for (int run = 0; run < 3000; ++run) {
        PlacedLevel place;
        place.samples = random() % 2 ? 4 : 1;
        const std::uint32_t sample = 1u << random() % 3;
        place.layout = ImageLayout::make(
            static_cast<Layout>(random() % 3), 4, 16, 19, 18, sample * place.samples);
        place.base = 1000 + sample * (random() % 9);
        const auto x = static_cast<std::uint32_t>(2 * (random() % 9));
        const auto y = static_cast<std::uint32_t>(2 * (random() % 9));
        const WrittenQuad quad{place.quad_addresses(x, y),
                               static_cast<std::uint8_t>(random() % 16),
                               static_cast<std::uint16_t>(random())};
        PixelBytes bytes;
        bytes.touched = static_cast<std::uint32_t>(random()) & ((1u << sample) - 1);
        bytes.covered = bytes.touched & static_cast<std::uint32_t>(random() % 2 ? ~0u : random());
        const LineGrain grain(8u << random() % 4); // a bit a byte
        const QuadBytes expected = bytes_of(place, quad, bytes);
        bool all_equal = true;
        for (std::uint64_t line = 900 / grain.line_bytes(); line < 9000 / grain.line_bytes();
             ++line) {
            WrittenBytes of_line;
            for (std::uint32_t i = 0; i < grain.line_bytes(); ++i) {
                const std::uint64_t at = line * grain.line_bytes() + i;
                of_line.touched |= LineMask{expected.touched.count(at)} << i;
                of_line.covered |= LineMask{expected.covered.count(at)} << i;
            }
            all_equal = all_equal && quad_bytes(place, grain, quad, line, bytes) == of_line;
        }
        CHECK(all_equal);
    }
}

} // namespace
} // namespace ffgpu::work
