#include "model/texture/texel_decode.h"

namespace ffgpu {
namespace {

Rgba decode_16(Format format, std::uint32_t bits) {
    switch (format) {
    case Format::Rgba4:
        return {
            widen4(bits >> 12), widen4(bits >> 8 & 15), widen4(bits >> 4 & 15), widen4(bits & 15)};
    case Format::Rgb5a1:
        return {widen5(bits >> 11),
                widen5(bits >> 6 & 31),
                widen5(bits >> 1 & 31),
                static_cast<std::uint8_t>((bits & 1) * 255)};
    default:
        return expand_rgb565(bits);
    }
}

} // namespace

Rgba decode_color_texel(Format format, const std::byte* at) {
    const auto byte = [at](unsigned i) { return std::to_integer<std::uint8_t>(at[i]); };
    switch (format) {
    case Format::Rgba8:
        return {byte(0), byte(1), byte(2), byte(3)};
    case Format::Rgbx8:
        return {byte(0), byte(1), byte(2), 255};
    case Format::Luminance8:
        return {byte(0), byte(0), byte(0), 255};
    case Format::Alpha8:
        return {0, 0, 0, byte(0)};
    case Format::Intensity8:
        return {byte(0), byte(0), byte(0), byte(0)};
    case Format::LuminanceAlpha8:
        return {byte(0), byte(0), byte(0), byte(1)};
    case Format::Rgb565:
    case Format::Rgba4:
    case Format::Rgb5a1:
        return decode_16(format, load16(at));
    default:
        return {0, 0, 0, 255};
    }
}

std::uint32_t decode_depth_texel(Format format, const std::byte* at) {
    if (format == Format::Depth24Stencil8) return load32(at) >> 8;
    const std::uint32_t depth = load16(at);
    return depth << 8 | depth >> 8;
}

} // namespace ffgpu
