#include "driver/texel/s3tc.h"

#include <algorithm>
#include <cstring>

namespace ffgpu::gl {

namespace {

using Palette = std::array<Rgba8Texel, 4>;

template <class Word>
Word load(const std::byte* at) {
    Word word;
    std::memcpy(&word, at, sizeof word);
    return word;
}

std::uint8_t byte_of(unsigned value) {
    return static_cast<std::uint8_t>(value);
}

Rgba8Texel expand565(unsigned color) {
    const unsigned r = color >> 11 & 31, g = color >> 5 & 63, b = color & 31;
    return {byte_of(r << 3 | r >> 2), byte_of(g << 2 | g >> 4), byte_of(b << 3 | b >> 2), 255};
}

// Each field to the nearest value, as expand565() widens it.
unsigned pack565(const Rgba8Texel& color) {
    const auto nearest = [](unsigned value, unsigned max) { return (value * max + 127) / 255; };
    return nearest(color[0], 31) << 11 | nearest(color[1], 63) << 5 | nearest(color[2], 31);
}

Rgba8Texel mix(const Rgba8Texel& a, unsigned weight_a, const Rgba8Texel& b, unsigned weight_b) {
    Rgba8Texel result{0, 0, 0, 255};
    for (std::size_t i = 0; i < 3; ++i)
        result[i] = byte_of((weight_a * a[i] + weight_b * b[i]) / (weight_a + weight_b));
    return result;
}

Palette color_palette(Format format, unsigned c0, unsigned c1) {
    const Rgba8Texel a = expand565(c0), b = expand565(c1);
    const bool is_dxt1 = format == Format::Dxt1Rgb || format == Format::Dxt1Rgba;
    if (!is_dxt1 || c0 > c1) return {a, b, mix(a, 2, b, 1), mix(a, 1, b, 2)};
    return {a, b, mix(a, 1, b, 1), {0, 0, 0, byte_of(format == Format::Dxt1Rgba ? 0 : 255)}};
}

std::array<std::uint8_t, 8> alpha_palette(unsigned a0, unsigned a1) {
    std::array<std::uint8_t, 8> palette{byte_of(a0), byte_of(a1)};
    const unsigned steps = a0 > a1 ? 7 : 5;
    for (unsigned i = 1; i < steps; ++i)
        palette[i + 1] = byte_of(((steps - i) * a0 + i * a1) / steps);
    if (steps == 5) palette[7] = 255;
    return palette;
}

bool has_alpha_block(Format format) {
    return format == Format::Dxt3 || format == Format::Dxt5;
}

struct Ends {
    Rgba8Texel low, high;
};

// The diagonal of the bounding box that runs with the colours: a channel that falls where the
// widest channel rises has its ends exchanged.
Ends find_ends(const TexelBlock& texels, const std::array<bool, 16>& clear) {
    Rgba8Texel low{255, 255, 255, 255}, high{0, 0, 0, 0};
    for (std::size_t i = 0; i < 16; ++i) {
        for (std::size_t c = 0; c < 3 && !clear[i]; ++c) {
            low[c] = std::min(low[c], texels[i][c]);
            high[c] = std::max(high[c], texels[i][c]);
        }
    }
    std::size_t widest = 0;
    for (std::size_t c = 1; c < 3; ++c) {
        if (high[c] - low[c] > high[widest] - low[widest]) widest = c;
    }
    for (std::size_t c = 0; c < 3; ++c) {
        int correlation = 0;
        for (std::size_t i = 0; i < 16; ++i) {
            if (clear[i]) continue;
            correlation += (2 * texels[i][c] - low[c] - high[c]) *
                           (2 * texels[i][widest] - low[widest] - high[widest]);
        }
        if (correlation < 0) std::swap(low[c], high[c]);
    }
    return {low, high};
}

int distance(const Rgba8Texel& a, const Rgba8Texel& b) {
    int sum = 0;
    for (std::size_t c = 0; c < 3; ++c)
        sum += (a[c] - b[c]) * (a[c] - b[c]);
    return sum;
}

void encode_colors(Format format, const TexelBlock& texels, std::byte* block) {
    std::array<bool, 16> clear{}; // Texels that DXT1 with alpha makes transparent.
    bool any_clear = false;
    if (format == Format::Dxt1Rgba) {
        for (std::size_t i = 0; i < 16; ++i)
            any_clear |= clear[i] = texels[i][3] < 128;
    }
    const Ends ends = find_ends(texels, clear);
    unsigned c0 = pack565(ends.high), c1 = pack565(ends.low);
    if ((c0 < c1) != any_clear) std::swap(c0, c1); // The order chooses the palette.
    const Palette palette = color_palette(format, c0, c1);
    const std::size_t entries = c0 > c1 || has_alpha_block(format) ? 4 : 3;

    std::uint32_t codes = 0;
    for (std::size_t i = 16; i-- > 0;) {
        std::uint32_t best = 0;
        for (std::uint32_t entry = 1; entry < entries; ++entry) {
            if (distance(palette[entry], texels[i]) < distance(palette[best], texels[i]))
                best = entry;
        }
        codes = codes << 2 | (clear[i] ? 3 : best);
    }
    const std::uint32_t words[2] = {c1 << 16 | c0, codes};
    std::memcpy(block, words, sizeof words);
}

std::uint64_t encode_alpha4(const TexelBlock& texels) {
    std::uint64_t alphas = 0;
    for (std::size_t i = 16; i-- > 0;)
        alphas = alphas << 4 | (texels[i][3] * 15u + 127) / 255;
    return alphas;
}

std::uint64_t encode_alpha8(const TexelBlock& texels) {
    unsigned low = 255, high = 0;
    for (const Rgba8Texel& texel : texels) {
        low = std::min<unsigned>(low, texel[3]);
        high = std::max<unsigned>(high, texel[3]);
    }
    const auto palette = alpha_palette(high, low);
    const std::size_t entries = high > low ? 8 : 1;
    std::uint64_t codes = 0;
    for (std::size_t i = 16; i-- > 0;) {
        const auto error = [&](std::size_t entry) {
            return std::abs(palette[entry] - texels[i][3]);
        };
        std::size_t best = 0;
        for (std::size_t entry = 1; entry < entries; ++entry) {
            if (error(entry) < error(best)) best = entry;
        }
        codes = codes << 3 | best;
    }
    return codes << 16 | low << 8 | high;
}

} // namespace

TexelBlock decode_block(Format format, const std::byte* block) {
    const std::byte* const colors = has_alpha_block(format) ? block + 8 : block;
    const Palette palette =
        color_palette(format, load<std::uint16_t>(colors), load<std::uint16_t>(colors + 2));
    const auto codes = load<std::uint32_t>(colors + 4);
    TexelBlock texels;
    for (std::size_t i = 0; i < 16; ++i)
        texels[i] = palette[codes >> (2 * i) & 3];
    if (!has_alpha_block(format)) return texels;

    const auto alphas = load<std::uint64_t>(block);
    const auto alpha8 = alpha_palette(alphas & 0xff, alphas >> 8 & 0xff);
    for (std::size_t i = 0; i < 16; ++i) {
        texels[i][3] = format == Format::Dxt3 ? byte_of((alphas >> (4 * i) & 15) * 17)
                                              : alpha8[alphas >> (16 + 3 * i) & 7];
    }
    return texels;
}

void encode_block(Format format, const TexelBlock& texels, std::byte* block) {
    if (has_alpha_block(format)) {
        const std::uint64_t alphas =
            format == Format::Dxt3 ? encode_alpha4(texels) : encode_alpha8(texels);
        std::memcpy(block, &alphas, sizeof alphas);
        block += sizeof alphas;
    }
    encode_colors(format, texels, block);
}

} // namespace ffgpu::gl
