// FXT1 blocks by hand, a coding each: bit positions as in 3DFX_texture_compression_FXT1.

#include "model/arith/fxt1.h"

#include <catch2/catch.hpp>

namespace ffgpu {
namespace {

using Color = Fxt1Block::Color;

// 128 bits, the lowest first.
struct Bits {
    std::array<std::byte, 16> bytes{};

    Bits& put(unsigned at, unsigned count, unsigned value) {
        for (unsigned i = 0; i < count; ++i)
            if ((value >> i & 1) != 0)
                bytes[(at + i) / 8] |= static_cast<std::byte>(1 << (at + i) % 8);
        return *this;
    }
    // Red, green, blue of five bits each.
    Bits& color(unsigned at, unsigned r, unsigned g, unsigned b) {
        return put(at, 15, r << 10 | g << 5 | b);
    }
    Color texel(unsigned x, unsigned y, bool alpha = true) const {
        return decode_fxt1(bytes.data(), x, y, alpha);
    }
};

TEST_CASE("FXT1 texels are numbered tile by tile, the left one first") {
    Bits block;
    block.put(125, 3, 2).color(64, 0, 0, 0).color(79, 31, 0, 0); // CC_CHROMA
    for (unsigned number = 0; number < 32; ++number) {
        Bits one = block;
        one.put(2 * number, 2, 1);
        for (unsigned y = 0; y < 4; ++y)
            for (unsigned x = 0; x < 8; ++x) {
                const bool same = number == (x < 4 ? 4 * y + x : 16 + 4 * y + x - 4);
                REQUIRE(one.texel(x, y) == (same ? Color{255, 0, 0, 255} : Color{0, 0, 0, 255}));
            }
    }
}

TEST_CASE("CC_HI has seven steps between its colours, and clear") {
    Bits block;
    block.color(96, 0, 31, 16).color(111, 31, 0, 16);
    for (unsigned code = 0; code < 8; ++code)
        block.put(3 * code, 3, code);          // texels 0 to 7: the left tile's first two rows
    block.put(3 * 21, 3, 6).put(3 * 31, 3, 3); // one that straddles the words, and the last
    for (unsigned code = 0; code < 7; ++code) {
        const auto red = static_cast<std::uint8_t>((255 * code + 3) / 6);
        const auto green = static_cast<std::uint8_t>((255 * (6 - code) + 3) / 6);
        CHECK(block.texel(code % 4, code / 4) == Color{red, green, 132, 255});
    }
    CHECK(block.texel(3, 1) == Color{0, 0, 0, 0});
    CHECK(block.texel(3, 1, false) == Color{0, 0, 0, 255});
    CHECK(block.texel(5, 1) == Color{255, 0, 132, 255});
    CHECK(block.texel(7, 3) == Color{128, 128, 132, 255});
}

TEST_CASE("CC_HI is told by two bits: the third is its second colour's highest") {
    Bits block;
    block.color(96, 31, 31, 31).color(111, 16, 0, 0); // Bit 125 is set.
    block.put(0, 3, 6);
    CHECK(block.texel(0, 0) == Color{132, 0, 0, 255});
}

TEST_CASE("CC_CHROMA has four colours") {
    Bits block;
    block.put(125, 3, 2).color(64, 31, 0, 0).color(79, 0, 31, 0).color(94, 0, 0, 31);
    block.color(109, 1, 2, 3);
    for (unsigned code = 0; code < 4; ++code)
        block.put(2 * code, 2, code);
    CHECK(block.texel(0, 0) == Color{255, 0, 0, 255});
    CHECK(block.texel(1, 0) == Color{0, 255, 0, 255});
    CHECK(block.texel(2, 0) == Color{0, 0, 255, 255});
    CHECK(block.texel(3, 0) == Color{8, 16, 24, 255});
}

TEST_CASE("CC_ALPHA has three colours with alpha and clear, or steps to a shared colour") {
    Bits block;
    block.put(125, 3, 3).color(64, 31, 0, 0).color(79, 0, 31, 0).color(94, 0, 0, 31);
    block.put(109, 5, 31).put(114, 5, 16).put(119, 5, 0);
    for (unsigned code = 0; code < 4; ++code)
        block.put(2 * code, 2, code).put(32 + 2 * code, 2, code);
    CHECK(block.texel(0, 0) == Color{255, 0, 0, 255});
    CHECK(block.texel(1, 0) == Color{0, 255, 0, 132});
    CHECK(block.texel(2, 0) == Color{0, 0, 255, 0});
    CHECK(block.texel(3, 0) == Color{0, 0, 0, 0});
    CHECK(block.texel(6, 0) == Color{0, 0, 255, 0});
    block.put(124, 1, 1);
    CHECK(block.texel(0, 0) == Color{255, 0, 0, 255});
    CHECK(block.texel(1, 0) == Color{170, 85, 0, 214});
    CHECK(block.texel(3, 0) == Color{0, 255, 0, 132});
    CHECK(block.texel(4, 0) == Color{0, 0, 255, 0});
    CHECK(block.texel(6, 0) == Color{0, 170, 85, 88});
    CHECK(block.texel(7, 0) == Color{0, 255, 0, 132});
}

TEST_CASE("CC_MIXED has steps between two colours of a tile, whose greens have a sixth bit") {
    Bits block;
    block.put(127, 1, 1).color(64, 0, 0, 0).color(79, 31, 31, 31);
    block.color(94, 31, 0, 0).color(109, 31, 16, 0);
    block.put(125, 1, 1).put(126, 1, 0); // The second colours' greens: 63 and 32.
    for (unsigned code = 0; code < 4; ++code)
        block.put(8 + 2 * code, 2, code).put(40 + 2 * code, 2, code);
    // The first texels' codes are 0: the first colours' greens have the same lowest bits.
    CHECK(block.texel(0, 1) == Color{0, 4, 0, 255});
    CHECK(block.texel(1, 1) == Color{85, 88, 85, 255});
    CHECK(block.texel(2, 1) == Color{170, 171, 170, 255});
    CHECK(block.texel(3, 1) == Color{255, 255, 255, 255});
    CHECK(block.texel(4, 1) == Color{255, 0, 0, 255});
    CHECK(block.texel(7, 1) == Color{255, 130, 0, 255});
    block.put(1, 1, 1).put(33, 1, 1); // Now they differ.
    CHECK(block.texel(0, 1) == Color{0, 0, 0, 255});
    CHECK(block.texel(4, 1) == Color{255, 4, 0, 255});
}

TEST_CASE("CC_MIXED with alpha has three colours of a tile and clear") {
    Bits block;
    block.put(127, 1, 1).put(124, 1, 1).color(64, 31, 1, 0).color(79, 0, 1, 31);
    block.put(125, 1, 1);
    for (unsigned code = 0; code < 4; ++code)
        block.put(2 * code, 2, code);
    CHECK(block.texel(0, 0) == Color{255, 8, 0, 255});
    CHECK(block.texel(1, 0) == Color{128, 10, 128, 255});
    CHECK(block.texel(2, 0) == Color{0, 12, 255, 255});
    CHECK(block.texel(3, 0) == Color{0, 0, 0, 0});
    CHECK(block.texel(3, 0, false) == Color{0, 0, 0, 255});
}

} // namespace
} // namespace ffgpu
