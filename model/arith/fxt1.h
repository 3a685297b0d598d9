// FXT1 blocks (3DFX_texture_compression_FXT1): 8x4 texels in 128 bits, read as one little-endian
// number, as two tiles of 4x4 side by side. Its upper bits choose one of four codings:
//
//     00   CC_HI      two colours, 3 bits a texel: seven steps between them, and clear
//     010  CC_CHROMA  four colours, 2 bits a texel
//     011  CC_ALPHA   three colours with alpha, 2 bits a texel: these and clear, or four steps
//                     between the tile's own colour and one that the tiles share
//     1    CC_MIXED   two colours a tile, 2 bits a texel: four steps, or three and clear
//
// Integer arithmetic: components widen to 8 bits by repeating their leading bits, then steps are
// ((n - i) a + i b) / n, rounded to nearest. Clear is (0, 0, 0, 0).

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace ffgpu {

class Fxt1Block {
public:
    using Color = std::array<std::uint8_t, 4>; // r g b a

    explicit constexpr Fxt1Block(const std::byte* at)
        : low_(load64(at))
        , high_(load64(at + 8)) {}

    // Texel (x, y), x 0 .. 7, y 0 .. 3, of the block's first row first.
    constexpr Color texel(unsigned x, unsigned y) const {
        const unsigned number = 16 * (x / 4) + 4 * y + x % 4;
        switch (bits(125, 3)) {
        case 0:
        case 1:
            return high_resolution(number);
        case 2:
            return color(64 + 15 * bits(2 * number, 2));
        case 3:
            return with_alpha(number);
        default:
            return mixed(number);
        }
    }

    // The i-th of n steps from a to b.
    static constexpr Color step(const Color& a, const Color& b, unsigned i, unsigned n) {
        Color result{};
        for (unsigned c = 0; c < 4; ++c)
            result[c] = static_cast<std::uint8_t>(((n - i) * a[c] + i * b[c] + n / 2) / n);
        return result;
    }

private:
    static constexpr std::uint64_t load64(const std::byte* at) {
        std::uint64_t word = 0;
        for (unsigned i = 8; i-- > 0;)
            word = word << 8 | std::to_integer<std::uint64_t>(at[i]);
        return word;
    }

    constexpr std::uint32_t bits(unsigned at, unsigned count) const {
        const std::uint64_t from = at >= 64  ? high_ >> (at - 64)
                                   : at == 0 ? low_
                                             : low_ >> at | high_ << (64 - at);
        return static_cast<std::uint32_t>(from & ((std::uint64_t{1} << count) - 1));
    }

    static constexpr std::uint8_t widen(std::uint32_t level, unsigned width) {
        return static_cast<std::uint8_t>(level << (8 - width) | level >> (2 * width - 8));
    }

    // Five bits a component, blue lowest.
    constexpr Color color(unsigned at) const {
        return {widen(bits(at + 10, 5), 5), widen(bits(at + 5, 5), 5), widen(bits(at, 5), 5), 255};
    }

    // The same with a sixth bit for green, its lowest.
    constexpr Color color(unsigned at, unsigned green_bit) const {
        Color result = color(at);
        result[1] = widen(bits(at + 5, 5) << 1 | green_bit, 6);
        return result;
    }

    constexpr Color color_alpha(unsigned i) const {
        Color result = color(64 + 15 * i);
        result[3] = widen(bits(109 + 5 * i, 5), 5);
        return result;
    }

    constexpr Color high_resolution(unsigned number) const {
        const unsigned code = bits(3 * number, 3);
        return code == 7 ? Color{} : step(color(96), color(111), code, 6);
    }

    constexpr Color with_alpha(unsigned number) const {
        const unsigned code = bits(2 * number, 2);
        const bool steps = bits(124, 1) != 0;
        if (steps) return step(color_alpha(number < 16 ? 0 : 2), color_alpha(1), code, 3);
        return code == 3 ? Color{} : color_alpha(code);
    }

    // A tile's two green bits are one: that of its second colour; the first's differs from it as
    // the upper code bit of the tile's first texel says. With a clear code the first has none.
    constexpr Color mixed(unsigned number) const {
        const unsigned tile = number / 16;
        const unsigned code = bits(2 * number, 2);
        const unsigned first = 64 + 30 * tile, green = bits(125 + tile, 1);
        const Color second = color(first + 15, green);
        if (bits(124, 1) != 0) return code == 3 ? Color{} : step(color(first), second, code, 2);
        return step(color(first, green ^ bits(32 * tile + 1, 1)), second, code, 3);
    }

    std::uint64_t low_, high_;
};

// With `alpha` off (COMPRESSED_RGB_FXT1_3DFX) every texel is opaque.
constexpr Fxt1Block::Color decode_fxt1(const std::byte* block, unsigned x, unsigned y, bool alpha) {
    Fxt1Block::Color texel = Fxt1Block(block).texel(x, y);
    if (!alpha) texel[3] = 255;
    return texel;
}

} // namespace ffgpu
