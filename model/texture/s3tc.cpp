#include "model/texture/s3tc.h"

#include "model/texture/texel_decode.h"

#include <cstdint>

namespace ffgpu {
namespace {

enum class Palette : std::uint8_t { FourColors, BlackWhenOrdered, ClearWhenOrdered };

Rgba mix_thirds(const Rgba& twice, const Rgba& once) {
    Rgba result{0, 0, 0, 255};
    for (unsigned channel = 0; channel < 3; ++channel)
        result[channel] = static_cast<std::uint8_t>((2 * twice[channel] + once[channel]) / 3);
    return result;
}

Rgba mix_halves(const Rgba& a, const Rgba& b) {
    Rgba result{0, 0, 0, 255};
    for (unsigned channel = 0; channel < 3; ++channel)
        result[channel] = static_cast<std::uint8_t>((a[channel] + b[channel]) / 2);
    return result;
}

// DXT1 tells its two palettes apart by the order of the end points as 16-bit numbers: the first
// must be the greater for four colours. The blocks of DXT3 and DXT5 always have four.
Rgba decode_color(const std::byte* block, unsigned texel, Palette palette) {
    const std::uint32_t c0 = load_word<std::uint16_t>(block),
                        c1 = load_word<std::uint16_t>(block + 2);
    const unsigned code = load_word<std::uint32_t>(block + 4) >> (2 * texel) & 3;
    const Rgba a = expand_rgb565(c0), b = expand_rgb565(c1);
    if (code == 0) return a;
    if (code == 1) return b;
    if (palette == Palette::FourColors || c0 > c1)
        return code == 2 ? mix_thirds(a, b) : mix_thirds(b, a);
    if (code == 2) return mix_halves(a, b);
    return {0, 0, 0, static_cast<std::uint8_t>(palette == Palette::ClearWhenOrdered ? 0 : 255)};
}

std::uint8_t decode_dxt3_alpha(const std::byte* block, unsigned texel) {
    const unsigned nibble =
        load_word<std::uint32_t>(block + texel / 8 * 4) >> (4 * (texel % 8)) & 0xf;
    return static_cast<std::uint8_t>(nibble * 17);
}

// Codes 2 to 7 run from the first alpha to the second in sevenths if the first is the greater,
// else codes 2 to 5 in fifths, 6 is 0 and 7 is 255.
std::uint8_t decode_dxt5_alpha(const std::byte* block, unsigned texel) {
    const std::uint64_t bits =
        load_word<std::uint32_t>(block) | std::uint64_t{load_word<std::uint32_t>(block + 4)} << 32;
    const unsigned a0 = bits & 0xff, a1 = bits >> 8 & 0xff;
    const unsigned code = bits >> (16 + 3 * texel) & 7;
    if (code < 2) return static_cast<std::uint8_t>(code == 0 ? a0 : a1);
    if (a0 > a1) return static_cast<std::uint8_t>(((8 - code) * a0 + (code - 1) * a1) / 7);
    if (code >= 6) return code == 6 ? 0 : 255;
    return static_cast<std::uint8_t>(((6 - code) * a0 + (code - 1) * a1) / 5);
}

} // namespace

Rgba decode_s3tc(Format format, const std::byte* block, unsigned x, unsigned y) {
    const unsigned texel = 4 * y + x;
    if (format == Format::Dxt1Rgb) return decode_color(block, texel, Palette::BlackWhenOrdered);
    if (format == Format::Dxt1Rgba) return decode_color(block, texel, Palette::ClearWhenOrdered);
    Rgba result = decode_color(block + 8, texel, Palette::FourColors);
    result[3] =
        format == Format::Dxt3 ? decode_dxt3_alpha(block, texel) : decode_dxt5_alpha(block, texel);
    return result;
}

} // namespace ffgpu
