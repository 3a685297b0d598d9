#include "driver/texel/texel_codec.h"

#include "driver/math/conversion.h"
#include "model/base/check.h"

#include <cstring>

namespace ffgpu::gl {

namespace {

// The fields of a 16-bit format, red first; alpha of 0 bits reads as 1.
struct Fields {
    unsigned shift[4];
    unsigned bits[4];
};

constexpr Fields fields_of(Format format) {
    switch (format) {
    case Format::Rgba4:
        return {{12, 8, 4, 0}, {4, 4, 4, 4}};
    case Format::Rgb5a1:
        return {{11, 6, 1, 0}, {5, 5, 5, 1}};
    default:
        return {{11, 5, 0, 0}, {5, 6, 5, 0}}; // Rgb565
    }
}

void encode_fields(const Fields& fields, std::span<const PixelColor> colors, std::byte* texels) {
    for (const PixelColor& color : colors) {
        std::uint32_t word = 0;
        for (std::size_t i = 0; i < 4; ++i)
            word |= unorm(static_cast<double>(color[i]), fields.bits[i]) << fields.shift[i];
        const auto stored = static_cast<std::uint16_t>(word);
        std::memcpy(texels, &stored, sizeof stored);
        texels += sizeof stored;
    }
}

void decode_fields(const Fields& fields, const std::byte* texels, std::span<PixelColor> colors) {
    for (PixelColor& color : colors) {
        std::uint16_t word;
        std::memcpy(&word, texels, sizeof word);
        texels += sizeof word;
        for (std::size_t i = 0; i < 4; ++i) {
            const unsigned max = (1u << fields.bits[i]) - 1;
            color[i] = max == 0 ? 1.0f
                                : static_cast<float>(word >> fields.shift[i] & max) /
                                      static_cast<float>(max);
        }
    }
}

} // namespace

ByteChannels byte_channels(Format format) {
    switch (format) {
    case Format::Rgba8:
        return {4, {0, 1, 2, 3}};
    case Format::Rgbx8:
        return {4, {0, 1, 2, ByteChannels::ReadsAsOne}};
    case Format::Luminance8:
    case Format::Intensity8:
        return {1, {0}};
    case Format::Alpha8:
        return {1, {3}};
    case Format::LuminanceAlpha8:
        return {2, {0, 3}};
    default:
        return {};
    }
}

void encode_colors(Format format, std::span<const PixelColor> colors, std::byte* texels) {
    const ByteChannels bytes = byte_channels(format);
    if (bytes.count == 0) return encode_fields(fields_of(format), colors, texels);
    for (const PixelColor& color : colors) {
        for (std::size_t i = 0; i < bytes.count; ++i) {
            const std::uint8_t channel = bytes.channel[i];
            *texels++ = channel == ByteChannels::ReadsAsOne
                            ? std::byte{255}
                            : static_cast<std::byte>(unorm(static_cast<double>(color[channel]), 8));
        }
    }
}

void decode_colors(Format format, const std::byte* texels, std::span<PixelColor> colors) {
    const ByteChannels bytes = byte_channels(format);
    if (bytes.count == 0) return decode_fields(fields_of(format), texels, colors);
    for (PixelColor& color : colors) {
        color = {0, 0, 0, 1};
        for (std::size_t i = 0; i < bytes.count; ++i) {
            const std::uint8_t channel = bytes.channel[i];
            const auto value = static_cast<float>(std::to_integer<unsigned>(*texels++)) / 255.0f;
            if (channel != ByteChannels::ReadsAsOne) color[channel] = value;
        }
    }
}

void encode_depths(Format format, std::span<const double> depths, std::byte* texels) {
    for (const double depth : depths) {
        if (format == Format::Depth16) {
            const auto stored = static_cast<std::uint16_t>(unorm(depth, 16));
            std::memcpy(texels, &stored, sizeof stored);
            texels += sizeof stored;
        } else {
            const std::uint32_t stored = unorm(depth, 24) << 8;
            std::memcpy(texels, &stored, sizeof stored);
            texels += sizeof stored;
        }
    }
}

void decode_depths(Format format, const std::byte* texels, std::span<double> depths) {
    check(format == Format::Depth16 || format == Format::Depth24Stencil8, "not a depth format");
    for (double& depth : depths) {
        if (format == Format::Depth16) {
            std::uint16_t stored;
            std::memcpy(&stored, texels, sizeof stored);
            texels += sizeof stored;
            depth = stored / 65535.0;
        } else {
            std::uint32_t stored;
            std::memcpy(&stored, texels, sizeof stored);
            texels += sizeof stored;
            depth = (stored >> 8) / 16777215.0;
        }
    }
}

} // namespace ffgpu::gl
