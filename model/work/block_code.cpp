#include "model/work/block_code.h"

#include "model/work/depth_code.h"

#include <algorithm>
#include <cstring>

namespace ffgpu::work {
namespace {

using Words = std::vector<std::uint32_t>;

// --- Channels ----------------------------------------------------------------------------------

// The fields of a colour format's pixel, the lowest bits first; they fill it.
std::span<const unsigned> channels_of(Format format) {
    static constexpr unsigned Rgba8[] = {8, 8, 8, 8}, One8[] = {8}, Two8[] = {8, 8},
                              Rgb565[] = {5, 6, 5}, Rgba4[] = {4, 4, 4, 4}, Rgb5a1[] = {1, 5, 5, 5};
    switch (format) {
    case Format::Luminance8:
    case Format::Alpha8:
    case Format::Intensity8:
        return One8;
    case Format::LuminanceAlpha8:
        return Two8;
    case Format::Rgb565:
        return Rgb565;
    case Format::Rgba4:
        return Rgba4;
    case Format::Rgb5a1:
        return Rgb5a1;
    default:
        return Rgba8;
    }
}

constexpr unsigned StepWidthBits = 4;

unsigned unsigned_width(std::uint32_t value) {
    unsigned width = 0;
    while (value >> width != 0)
        ++width;
    return width;
}

// A step modulo 2^bits, as the signed number nearest to 0.
std::int32_t wrapped(std::uint32_t step, unsigned bits) {
    const unsigned spare = 32 - bits;
    return static_cast<std::int32_t>(step << spare) >> spare;
}
unsigned signed_width(std::int32_t value) {
    if (value == 0) return 0;
    return unsigned_width(static_cast<std::uint32_t>(value < 0 ? ~value : value)) + 1;
}

// The pixel that pixel i > 0 is told from: on its left, else below.
std::size_t neighbour(std::size_t i, std::uint32_t width) {
    return i % width != 0 ? i - 1 : i - width;
}

void encode_channel(const Words& values, std::uint32_t width, unsigned bits, BitWriter& out) {
    const std::uint32_t least = *std::min_element(values.begin(), values.end());
    const unsigned offset_width =
        unsigned_width(*std::max_element(values.begin(), values.end()) - least);
    unsigned step_width = 0;
    for (std::size_t i = 1; i < values.size(); ++i)
        step_width = std::max(step_width,
                              signed_width(wrapped(values[i] - values[neighbour(i, width)], bits)));
    const bool steps = step_width * (values.size() - 1) < offset_width * values.size();
    out.put(steps, 1);
    out.put(steps ? values[0] : least, bits);
    out.put(steps ? step_width : offset_width, StepWidthBits);
    for (std::size_t i = steps; i < values.size(); ++i)
        steps ? out.put(values[i] - values[neighbour(i, width)], step_width)
              : out.put(values[i] - least, offset_width);
}

void decode_channel(BitReader& in, std::uint32_t width, unsigned bits, Words& values) {
    const bool steps = in.get(1) != 0;
    const std::uint32_t base = in.get(bits);
    const unsigned step_width = in.get(StepWidthBits);
    const std::uint32_t mask = (1u << bits) - 1;
    if (steps) values[0] = base;
    for (std::size_t i = steps; i < values.size(); ++i)
        values[i] = steps ? (values[neighbour(i, width)] +
                             static_cast<std::uint32_t>(in.get_signed(step_width))) &
                                mask
                          : base + in.get(step_width);
}

void encode_colors(const BlockShape& shape, const Words& words, BitWriter& out) {
    unsigned shift = 0;
    Words values(words.size());
    for (const unsigned bits : channels_of(shape.format)) {
        for (std::size_t i = 0; i < words.size(); ++i)
            values[i] = words[i] >> shift & ((1u << bits) - 1);
        encode_channel(values, shape.width, bits, out);
        shift += bits;
    }
}

void decode_colors(const BlockShape& shape, BitReader& in, Words& words) {
    unsigned shift = 0;
    std::fill(words.begin(), words.end(), 0);
    Words values(words.size());
    for (const unsigned bits : channels_of(shape.format)) {
        decode_channel(in, shape.width, bits, values);
        for (std::size_t i = 0; i < words.size(); ++i)
            words[i] |= values[i] << shift;
        shift += bits;
    }
}

// --- Depth and stencil -------------------------------------------------------------------------

constexpr unsigned StencilBits = 8;

bool has_stencil(Format format) {
    return format == Format::Depth24Stencil8;
}
DepthGrid grid_of(const BlockShape& shape) {
    return {shape.width, shape.height, has_stencil(shape.format) ? 24u : 16u};
}

void encode_depth_words(const BlockShape& shape, const Words& words, BitWriter& out) {
    if (!has_stencil(shape.format)) return encode_depths(grid_of(shape), words, out);
    Words depths, stencils;
    for (const std::uint32_t word : words) {
        depths.push_back(word >> StencilBits);
        stencils.push_back(word & 0xff);
    }
    encode_depths(grid_of(shape), depths, out);
    const bool uniform = std::count(stencils.begin(), stencils.end(), stencils[0]) ==
                         static_cast<std::ptrdiff_t>(stencils.size());
    out.put(uniform, 1);
    for (std::size_t i = 0; i < (uniform ? 1 : stencils.size()); ++i)
        out.put(stencils[i], StencilBits);
}

void decode_depth_words(const BlockShape& shape, BitReader& in, Words& words) {
    decode_depths(grid_of(shape), in, words);
    if (!has_stencil(shape.format)) return;
    const bool uniform = in.get(1) != 0;
    std::uint32_t stencil = uniform ? in.get(StencilBits) : 0;
    for (std::uint32_t& word : words) {
        if (!uniform) stencil = in.get(StencilBits);
        word = word << StencilBits | stencil;
    }
}

// --- Samples -----------------------------------------------------------------------------------

Words words_of(const BlockShape& shape, std::span<const std::byte> block, unsigned sample) {
    Words words(shape.pixels());
    for (std::size_t i = 0; i < words.size(); ++i)
        std::memcpy(&words[i],
                    block.data() + (i * shape.samples + sample) * shape.sample_bytes(),
                    shape.sample_bytes());
    return words;
}

} // namespace

std::vector<std::uint8_t> encode_block(const BlockShape& shape, std::span<const std::byte> block) {
    const auto encode = format_info(shape.format).is_depth ? encode_depth_words : encode_colors;
    BitWriter out;
    const Words first = words_of(shape, block, 0);
    encode(shape, first, out);
    for (unsigned sample = 1; sample < shape.samples; ++sample) {
        const Words words = words_of(shape, block, sample);
        out.put(words == first, 1);
        if (words != first) encode(shape, words, out);
    }
    return out.take();
}

void decode_block(const BlockShape& shape,
                  std::span<const std::uint8_t> code,
                  std::span<std::byte> block) {
    const auto decode = format_info(shape.format).is_depth ? decode_depth_words : decode_colors;
    BitReader in(code);
    Words first(shape.pixels());
    for (unsigned sample = 0; sample < shape.samples; ++sample) {
        Words words = first;
        if (sample == 0 || in.get(1) == 0) decode(shape, in, words);
        if (sample == 0) first = words;
        for (std::size_t i = 0; i < words.size(); ++i)
            std::memcpy(block.data() + (i * shape.samples + sample) * shape.sample_bytes(),
                        &words[i],
                        shape.sample_bytes());
    }
}

} // namespace ffgpu::work
