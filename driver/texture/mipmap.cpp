#include "driver/texture/mipmap.h"

#include "driver/texel/block_codec.h"
#include "driver/texel/texel_codec.h"
#include "model/arith/srgb.h"

#include <algorithm>
#include <cstring>

namespace ffgpu::gl {

namespace {

// Along one axis a texel covers up to three texels of the level above, weighted by how much of each
// it covers; the weights add up to `total`.
struct Taps {
    std::uint32_t first = 0;
    std::uint32_t count = 1;
    std::uint32_t weight[3] = {};
};

struct Axis {
    std::vector<Taps> taps; // by texel
    std::uint32_t total = 1;
};

std::uint32_t whole(GLsizei size) {
    return static_cast<std::uint32_t>(size);
}

Axis make_axis(GLsizei from, GLsizei to, GLint border) {
    const std::uint32_t n = whole(from - 2 * border), m = whole(to - 2 * border);
    const std::uint32_t b = whole(border);
    Axis axis;
    axis.total = n == m ? 1 : n % 2 == 0 ? 2 : n;
    if (border != 0) axis.taps.push_back({0, 1, {axis.total}});
    for (std::uint32_t i = 0; i < m; ++i) {
        if (n == m) {
            axis.taps.push_back({b + i, 1, {1}});
        } else if (n % 2 == 0) {
            axis.taps.push_back({b + 2 * i, 2, {1, 1}});
        } else {
            axis.taps.push_back({b + 2 * i, 3, {m - i, m, i + 1}});
        }
    }
    if (border != 0) axis.taps.push_back({b + n, 1, {axis.total}});
    return axis;
}

struct Axes {
    Axis x, y, z;

    std::uint64_t total() const { return std::uint64_t{x.total} * y.total * z.total; }
};

// Calls visitor(texel of the level above, its weight) for what texel (x, y, z) covers.
template <class Visitor>
void for_each_tap(const Taps& x, const Taps& y, const Taps& z, Visitor&& visitor) {
    for (std::uint32_t k = 0; k < z.count; ++k) {
        for (std::uint32_t j = 0; j < y.count; ++j) {
            const std::uint64_t weight = std::uint64_t{z.weight[k]} * y.weight[j];
            for (std::uint32_t i = 0; i < x.count; ++i)
                visitor(x.first + i, y.first + j, z.first + k, weight * x.weight[i]);
        }
    }
}

// Channels of a word as fields.
struct Fields {
    std::uint8_t count = 0;
    std::uint8_t shift[4] = {};
    std::uint8_t bits[4] = {};
    bool srgb[4] = {}; // The mean is one of linear light.

    std::uint32_t load(std::size_t channel, std::uint32_t word) const {
        const std::uint32_t value = word >> shift[channel] & ((1u << bits[channel]) - 1);
        return srgb[channel] ? SrgbToLinear16[value] : value;
    }
    std::uint32_t store(std::size_t channel, std::uint32_t mean) const {
        return std::uint32_t{srgb[channel] ? srgb_from_linear16(mean) : mean} << shift[channel];
    }
};

Fields fields_of(InternalFormat format) {
    switch (format.format) {
    case Format::Rgb565:
        return {3, {11, 5, 0}, {5, 6, 5}};
    case Format::Rgba4:
        return {4, {12, 8, 4, 0}, {4, 4, 4, 4}};
    case Format::Rgb5a1:
        return {4, {11, 6, 1, 0}, {5, 5, 5, 1}};
    case Format::Depth16:
        return {1, {0}, {16}};
    case Format::Depth24Stencil8:
        return {1, {8}, {24}};
    default:
        break;
    }
    const ByteChannels channels = byte_channels(format.format);
    Fields fields{channels.count, {0, 8, 16, 24}, {8, 8, 8, 8}, {}};
    for (std::size_t c = 0; c < channels.count; ++c)
        fields.srgb[c] = format.srgb && channels.channel[c] < 3;
    return fields;
}

std::uint32_t load_word(const std::byte* at, std::size_t bytes) {
    std::uint32_t word = 0;
    std::memcpy(&word, at, bytes);
    return word;
}

// The weighted mean of the texels that one texel covers, channel by channel, rounded to nearest.
struct Mean {
    Axes axes;
    Fields fields;

    Mean(const TextureLevel& from, const TextureLevel& to)
        : fields(fields_of(from.format)) {
        const bool flat = from.height == 1 && to.height == 1; // One dimension has no border in y.
        const bool solid = from.depth > 1 || to.depth > 1;
        axes = {make_axis(from.width, to.width, from.border),
                make_axis(from.height, to.height, flat ? 0 : from.border),
                make_axis(from.depth, to.depth, solid ? from.border : 0)};
    }

    template <class Read>
    std::uint32_t of(const Taps& x, const Taps& y, const Taps& z, Read&& word_at) const {
        std::uint64_t sums[4] = {};
        for_each_tap(x, y, z, [&](auto i, auto j, auto k, std::uint64_t weight) {
            const std::uint32_t word = word_at(i, j, k);
            for (std::size_t c = 0; c < fields.count; ++c)
                sums[c] += weight * fields.load(c, word);
        });
        const std::uint64_t total = axes.total();
        std::uint32_t result = 0;
        for (std::size_t c = 0; c < fields.count; ++c)
            result |= fields.store(c, static_cast<std::uint32_t>((sums[c] + total / 2) / total));
        return result;
    }
};

// The common case: four bytes a texel, two by two.
bool halve_words_of_bytes(const TextureLevel& from,
                          const TextureLevel& to,
                          const std::byte* texels,
                          std::byte* result) {
    const Format format = from.format.format;
    const bool four_bytes = format == Format::Rgba8 || format == Format::Rgbx8;
    if (!four_bytes || from.format.srgb || from.border != 0 || from.depth != 1) return false;
    if (from.width != 2 * to.width || from.height != 2 * to.height) return false;
    const std::size_t row = std::size_t{4} * whole(from.width);
    for (std::size_t y = 0; y < whole(to.height); ++y) {
        const std::byte* above = texels + 2 * y * row;
        for (std::size_t x = 0; x < whole(to.width); ++x, above += 8) {
            for (std::size_t i = 0; i < 4; ++i, ++result) {
                const unsigned sum = std::to_integer<unsigned>(above[i]) +
                                     std::to_integer<unsigned>(above[i + 4]) +
                                     std::to_integer<unsigned>(above[i + row]) +
                                     std::to_integer<unsigned>(above[i + row + 4]);
                *result = static_cast<std::byte>((sum + 2) / 4);
            }
        }
    }
    return true;
}

TextureLevel next_level(const TextureLevel& above, TextureTarget target) {
    const auto halved = [&](GLsizei size) {
        return std::max((size - 2 * above.border) / 2, 1) + 2 * above.border;
    };
    TextureLevel level;
    level.internal_format = above.internal_format;
    level.format = above.format;
    level.border = above.border;
    level.width = halved(above.width);
    level.height = target == TextureTarget::OneD ? 1 : halved(above.height);
    level.depth = target == TextureTarget::ThreeD ? halved(above.depth) : 1;
    return level;
}

BlockImageSize size_of(const TextureLevel& level) {
    return {whole(level.width), whole(level.height), whole(level.depth)};
}

// A compressed level is taken apart, halved and compressed again.
std::vector<std::byte>
halve_compressed(const TextureLevel& from, const TextureLevel& to, std::vector<std::byte>& rgba) {
    TextureLevel above = from, below = to;
    above.format.format = below.format.format = Format::Rgba8;
    rgba = halve_image(above, below, rgba);
    return compress(from.format.format, rgba.data(), size_of(to));
}

} // namespace

std::vector<std::byte> halve_image(const TextureLevel& from,
                                   const TextureLevel& to,
                                   const std::vector<std::byte>& texels) {
    const Format format = from.format.format;
    const std::size_t bytes = format_info(format).block_bytes;
    std::vector<std::byte> result(box_bytes(format, whole_box(to)));
    if (halve_words_of_bytes(from, to, texels.data(), result.data())) return result;

    const Mean mean(from, to);
    const auto word_at = [&](std::size_t x, std::size_t y, std::size_t z) {
        const std::size_t at = (z * whole(from.height) + y) * whole(from.width) + x;
        return load_word(texels.data() + at * bytes, bytes);
    };
    std::byte* out = result.data();
    for (const Taps& z : mean.axes.z.taps) {
        for (const Taps& y : mean.axes.y.taps) {
            for (const Taps& x : mean.axes.x.taps) {
                const std::uint32_t word = mean.of(x, y, z, word_at);
                std::memcpy(out, &word, bytes);
                out += bytes;
            }
        }
    }
    return result;
}

void generate_mipmaps(DeviceMemory memory, TextureObject& texture, unsigned face) {
    const TextureParameters& parameters = texture.parameters;
    if (parameters.base_level < 0 || parameters.base_level >= GLint{MaxTextureLevels}) return;
    auto number = static_cast<unsigned>(parameters.base_level);
    const TextureLevel* above = &texture.level(face, number);
    if (!above->defined()) return;
    const bool compressed = is_compressed(above->format.format);
    std::vector<std::byte> texels = read_texels(memory, texture, {face, number}, whole_box(*above));
    if (compressed) {
        texels = decompress(above->format.format, texels.data(), size_of(*above));
    }
    const GLint last = std::min<GLint>(parameters.max_level, MaxTextureLevels - 1);
    while (static_cast<GLint>(number) < last) {
        const TextureLevel level = next_level(*above, texture.target());
        if (level.width == above->width && level.height == above->height &&
            level.depth == above->depth) {
            return; // One texel.
        }
        ++number;
        if (compressed) {
            define_image(
                memory, texture, {face, number}, level, halve_compressed(*above, level, texels));
        } else {
            texels = halve_image(*above, level, texels);
            define_image(memory, texture, {face, number}, level, texels);
        }
        above = &texture.level(face, number);
    }
}

} // namespace ffgpu::gl
