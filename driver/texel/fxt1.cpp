#include "driver/texel/fxt1.h"

#include "model/arith/fxt1.h"

#include <algorithm>
#include <cstring>
#include <vector>

namespace ffgpu::gl {

namespace {

// 128 bits that are written once.
struct BlockBits {
    std::uint64_t words[2] = {};

    void put(unsigned at, unsigned count, std::uint64_t value) {
        words[at / 64] |= value << at % 64;
        if (at % 64 + count > 64) words[1] |= value >> (64 - at);
    }
    void store(std::byte* block) const { std::memcpy(block, words, sizeof words); }
};

constexpr unsigned Tile = 4; // texels a side

// The texel of a tile, in the order of the codes.
const Rgba8Texel& tile_texel(const Fxt1Texels& texels, unsigned tile, unsigned i) {
    return texels[8 * (i / Tile) + Tile * tile + i % Tile];
}

int distance(const Rgba8Texel& a, const Rgba8Texel& b) {
    int sum = 0;
    for (std::size_t c = 0; c < 4; ++c)
        sum += (a[c] - b[c]) * (a[c] - b[c]);
    return sum;
}

std::uint32_t level(std::uint8_t value, unsigned bits) {
    const std::uint32_t most = (1u << bits) - 1;
    return (value * most + 127) / 255;
}

std::uint8_t widened(std::uint32_t level, unsigned bits) {
    return static_cast<std::uint8_t>(level << (8 - bits) | level >> (2 * bits - 8));
}

// As it reads once it has passed through `bits` a component.
Rgba8Texel rounded(const Rgba8Texel& color, const std::array<unsigned, 4>& bits) {
    Rgba8Texel result;
    for (std::size_t c = 0; c < 4; ++c)
        result[c] = widened(level(color[c], bits[c]), bits[c]);
    return result;
}

constexpr std::array<unsigned, 4> Bits565{5, 6, 5, 8}, Bits5555{5, 5, 5, 5};

// Five bits a component, blue lowest; of the six bits of a 565 colour's green the upper five.
std::uint64_t packed(const Rgba8Texel& color, unsigned green_bits) {
    const std::uint32_t green = level(color[1], green_bits) >> (green_bits - 5);
    return level(color[0], 5) << 10 | green << 5 | level(color[2], 5);
}

// The code of the nearest of n + 1 steps.
unsigned
nearest_step(const Rgba8Texel& a, const Rgba8Texel& b, unsigned n, const Rgba8Texel& texel) {
    unsigned best = 0;
    for (unsigned i = 1; i <= n; ++i) {
        if (distance(Fxt1Block::step(a, b, i, n), texel) <
            distance(Fxt1Block::step(a, b, best, n), texel)) {
            best = i;
        }
    }
    return best;
}

// --- CC_MIXED -----------------------------------------------------------------------------------

struct Ends {
    Rgba8Texel first, second;
};

// The two texels that differ most.
Ends find_ends(const Fxt1Texels& texels, unsigned tile) {
    Ends ends{tile_texel(texels, tile, 0), tile_texel(texels, tile, 0)};
    for (unsigned i = 0; i < 16; ++i) {
        for (unsigned j = i + 1; j < 16; ++j) {
            const Rgba8Texel &a = tile_texel(texels, tile, i), &b = tile_texel(texels, tile, j);
            if (distance(a, b) > distance(ends.first, ends.second)) ends = {a, b};
        }
    }
    return {rounded(ends.first, Bits565), rounded(ends.second, Bits565)};
}

// Whether the greens of both ends differ in their lowest bit is told by the upper bit of the first
// texel's code: where that bit is another, the ends change places and all codes with them.
void encode_mixed_tile(const Fxt1Texels& texels, unsigned tile, BlockBits& block) {
    Ends ends = find_ends(texels, tile);
    std::array<unsigned, 16> codes;
    for (unsigned i = 0; i < 16; ++i)
        codes[i] = nearest_step(ends.first, ends.second, 3, tile_texel(texels, tile, i));
    const auto green_bit = [](const Rgba8Texel& color) { return level(color[1], 6) & 1; };
    if (codes[0] >> 1 != (green_bit(ends.first) ^ green_bit(ends.second))) {
        std::swap(ends.first, ends.second);
        for (unsigned& code : codes)
            code = 3 - code;
    }
    for (unsigned i = 0; i < 16; ++i)
        block.put(32 * tile + 2 * i, 2, codes[i]);
    block.put(64 + 30 * tile, 15, packed(ends.first, 6));
    block.put(79 + 30 * tile, 15, packed(ends.second, 6));
    block.put(125 + tile, 1, green_bit(ends.second));
}

BlockBits encode_mixed(Fxt1Texels texels) {
    for (Rgba8Texel& texel : texels)
        texel[3] = 255;
    BlockBits block;
    block.put(127, 1, 1);
    encode_mixed_tile(texels, 0, block);
    encode_mixed_tile(texels, 1, block);
    return block;
}

// --- CC_ALPHA -----------------------------------------------------------------------------------

constexpr Rgba8Texel Clear{};

void put_color_alpha(BlockBits& block, unsigned i, const Rgba8Texel& color) {
    block.put(64 + 15 * i, 15, packed(color, 5));
    block.put(109 + 5 * i, 5, level(color[3], 5));
}

// The block's colours besides clear, in five bits a component; more than three: there is no such
// palette.
std::vector<Rgba8Texel> find_palette(const Fxt1Texels& texels) {
    std::vector<Rgba8Texel> palette;
    for (const Rgba8Texel& texel : texels) {
        const Rgba8Texel color = rounded(texel, Bits5555);
        const bool known = std::find(palette.begin(), palette.end(), color) != palette.end();
        if (color != Clear && !known) palette.push_back(color);
        if (palette.size() > 3) break;
    }
    return palette;
}

void encode_palette(const Fxt1Texels& texels,
                    const std::vector<Rgba8Texel>& palette,
                    BlockBits& block) {
    for (unsigned i = 0; i < palette.size(); ++i)
        put_color_alpha(block, i, palette[i]);
    for (unsigned i = 0; i < 32; ++i) {
        const Rgba8Texel color = rounded(tile_texel(texels, i / 16, i % 16), Bits5555);
        const auto entry = std::find(palette.begin(), palette.end(), color);
        block.put(2 * i, 2, color == Clear ? 3u : static_cast<unsigned>(entry - palette.begin()));
    }
}

// Of `count` texels the one that differs most from `from`.
template <class Texel>
Rgba8Texel farthest(const Rgba8Texel& from, unsigned count, Texel&& texel) {
    Rgba8Texel found = texel(0u);
    for (unsigned i = 1; i < count; ++i) {
        if (distance(texel(i), from) > distance(found, from)) found = texel(i);
    }
    return found;
}

// The shared colour is the texel farthest from the mean, a tile's own the one farthest from that.
void encode_steps(const Fxt1Texels& texels, BlockBits& block) {
    Rgba8Texel mean;
    for (std::size_t c = 0; c < 4; ++c) {
        unsigned sum = 0;
        for (const Rgba8Texel& texel : texels)
            sum += texel[c];
        mean[c] = static_cast<std::uint8_t>(sum / 32);
    }
    const Rgba8Texel shared =
        rounded(farthest(mean, 32, [&](unsigned i) { return texels[i]; }), Bits5555);
    put_color_alpha(block, 1, shared);
    for (unsigned tile = 0; tile < 2; ++tile) {
        const auto texel = [&](unsigned i) { return tile_texel(texels, tile, i); };
        const Rgba8Texel own = rounded(farthest(shared, 16, texel), Bits5555);
        put_color_alpha(block, 2 * tile, own);
        for (unsigned i = 0; i < 16; ++i)
            block.put(32 * tile + 2 * i, 2, nearest_step(own, shared, 3, texel(i)));
    }
    block.put(124, 1, 1);
}

BlockBits encode_alpha(const Fxt1Texels& texels) {
    BlockBits block;
    block.put(125, 3, 3);
    const std::vector<Rgba8Texel> palette = find_palette(texels);
    if (palette.size() <= 3) {
        encode_palette(texels, palette, block);
    } else {
        encode_steps(texels, block);
    }
    return block;
}

} // namespace

void encode_fxt1(const Fxt1Texels& texels, bool alpha, std::byte* block) {
    const auto is_opaque = [](const Rgba8Texel& texel) { return texel[3] == 255; };
    const bool opaque = !alpha || std::all_of(texels.begin(), texels.end(), is_opaque);
    (opaque ? encode_mixed(texels) : encode_alpha(texels)).store(block);
}

} // namespace ffgpu::gl
