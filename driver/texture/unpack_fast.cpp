// Uploads of bytes: most textures of most programs.

#include "driver/pixel/pixel_format.h"
#include "driver/texel/texel_codec.h"
#include "driver/texture/image_upload.h"

#include <cstring>

namespace ffgpu::gl {

namespace {

// What a texel's byte takes: byte 0 to 3 of the source pixel, or a constant.
constexpr std::uint8_t TakesZero = 4, TakesOne = 5;

struct ByteMap {
    unsigned source_bytes = 0;
    unsigned texel_bytes = 0;
    std::uint8_t take[4] = {};
};

// A word of four 8-bit fields is bytes in memory, in one order or the other.
bool is_bytes(GLenum type, bool swap, bool& reversed) {
    const bool forward = type == GL_UNSIGNED_INT_8_8_8_8_REV;
    const bool backward = type == GL_UNSIGNED_INT_8_8_8_8;
    reversed = swap ? forward : backward;
    return type == GL_UNSIGNED_BYTE || forward || backward;
}

bool find_map(const PixelSource& source, Format format, ByteMap& map) {
    const ComponentOrder order = component_order(source.format);
    const ByteChannels texel = byte_channels(format);
    bool reversed = false;
    if (order.kind != PixelKind::Color || texel.count == 0) return false;
    if (!is_bytes(source.type, source.swap_bytes, reversed)) return false;
    if (source.type == GL_UNSIGNED_BYTE) reversed = false;

    std::uint8_t byte_of_channel[4] = {TakesZero, TakesZero, TakesZero, TakesOne};
    for (std::uint8_t i = 0; i < order.count; ++i)
        byte_of_channel[order.channel[i]] =
            reversed ? static_cast<std::uint8_t>(order.count - 1 - i) : i;
    if (order.luminance) byte_of_channel[1] = byte_of_channel[2] = byte_of_channel[0];

    map.source_bytes = order.count;
    map.texel_bytes = texel.count;
    for (std::size_t i = 0; i < texel.count; ++i) {
        const std::uint8_t channel = texel.channel[i];
        map.take[i] = channel == ByteChannels::ReadsAsOne ? TakesOne : byte_of_channel[channel];
    }
    return true;
}

bool keeps_order(const ByteMap& map) {
    for (std::uint8_t i = 0; i < map.texel_bytes; ++i) {
        if (map.take[i] != i) return false;
    }
    return map.source_bytes == map.texel_bytes;
}

// Sizes known to the compiler; bytes 4 and 5 of `pixel` are the constants.
template <unsigned SourceBytes, unsigned TexelBytes>
void convert_row(const ByteMap& map, const std::byte* from, std::size_t count, std::byte* to) {
    std::byte pixel[6] = {{}, {}, {}, {}, std::byte{0}, std::byte{255}};
    const ByteMap local = map; // Not touched by the stores below.
    for (std::size_t x = 0; x < count; ++x) {
        std::memcpy(pixel, from + x * SourceBytes, SourceBytes);
        for (std::size_t i = 0; i < TexelBytes; ++i)
            to[x * TexelBytes + i] = pixel[local.take[i]];
    }
}

void rgb_to_rgbx(const std::byte* from, std::size_t count, std::byte* to) {
    for (std::size_t x = 0; x < count; ++x) {
        to[4 * x] = from[3 * x];
        to[4 * x + 1] = from[3 * x + 1];
        to[4 * x + 2] = from[3 * x + 2];
        to[4 * x + 3] = std::byte{255};
    }
}

void bgra_to_rgba(const std::byte* from, std::size_t count, std::byte* to, std::uint32_t set) {
    for (std::size_t x = 0; x < count; ++x) {
        std::uint32_t word;
        std::memcpy(&word, from + 4 * x, 4);
        word = (word & 0xff00ff00) | (word >> 16 & 0xff) | (word & 0xff) << 16 | set;
        std::memcpy(to + 4 * x, &word, 4);
    }
}

using RowConverter = void (*)(const ByteMap&, const std::byte*, std::size_t, std::byte*);

template <unsigned SourceBytes>
constexpr RowConverter Converters[4] = {convert_row<SourceBytes, 1>,
                                        convert_row<SourceBytes, 2>,
                                        nullptr, // No format has texels of three bytes.
                                        convert_row<SourceBytes, 4>};

RowConverter choose_converter(const ByteMap& map) {
    if (keeps_order(map)) {
        return [](const ByteMap& m, const std::byte* from, std::size_t count, std::byte* to) {
            std::memcpy(to, from, count * m.texel_bytes);
        };
    }
    const auto takes = [&](std::uint8_t r, std::uint8_t g, std::uint8_t b, std::uint8_t a) {
        return map.texel_bytes == 4 && map.take[0] == r && map.take[1] == g && map.take[2] == b &&
               map.take[3] == a;
    };
    if (map.source_bytes == 3 && takes(0, 1, 2, TakesOne)) {
        return [](const ByteMap&, const std::byte* from, std::size_t count, std::byte* to) {
            rgb_to_rgbx(from, count, to);
        };
    }
    if (map.source_bytes == 4 && takes(2, 1, 0, 3)) {
        return [](const ByteMap&, const std::byte* from, std::size_t count, std::byte* to) {
            bgra_to_rgba(from, count, to, 0);
        };
    }
    if (map.source_bytes == 4 && takes(2, 1, 0, TakesOne)) {
        return [](const ByteMap&, const std::byte* from, std::size_t count, std::byte* to) {
            bgra_to_rgba(from, count, to, 0xff000000);
        };
    }
    switch (map.source_bytes) {
    case 1:
        return Converters<1>[map.texel_bytes - 1];
    case 2:
        return Converters<2>[map.texel_bytes - 1];
    case 3:
        return Converters<3>[map.texel_bytes - 1];
    default:
        return Converters<4>[map.texel_bytes - 1];
    }
}

// 16-bit pixels that are stored as they come.
bool is_same_word(const PixelSource& source, Format format) {
    if (source.swap_bytes) return false;
    switch (format) {
    case Format::Rgb565:
        return source.format == GL_RGB && source.type == GL_UNSIGNED_SHORT_5_6_5;
    case Format::Rgba4:
        return source.format == GL_RGBA && source.type == GL_UNSIGNED_SHORT_4_4_4_4;
    case Format::Rgb5a1:
        return source.format == GL_RGBA && source.type == GL_UNSIGNED_SHORT_5_5_5_1;
    case Format::Depth16:
        return source.format == GL_DEPTH_COMPONENT && source.type == GL_UNSIGNED_SHORT;
    default:
        return false;
    }
}

} // namespace

bool unpack_fast(const PixelSource& source, Format format, std::byte* texels) {
    ByteMap map;
    RowConverter convert = nullptr;
    if (is_same_word(source, format)) {
        map.texel_bytes = 2;
        convert = [](const ByteMap&, const std::byte* from, std::size_t count, std::byte* to) {
            std::memcpy(to, from, 2 * count);
        };
    } else if (find_map(source, format, map)) {
        convert = choose_converter(map);
    } else {
        return false;
    }
    const std::size_t row = source.width() * map.texel_bytes;
    for (GLsizei z = 0; z < source.size.depth; ++z) {
        for (GLsizei y = 0; y < source.size.height; ++y, texels += row)
            convert(map, source.row(y, z), source.width(), texels);
    }
    return true;
}

} // namespace ffgpu::gl
