#include "driver/texel/internal_format.h"

#include <algorithm>
#include <array>

namespace ffgpu::gl {

namespace {

struct Row {
    GLenum token;
    BaseFormat base;
    Format format;
    bool srgb = false;
};

using enum BaseFormat;

constexpr std::array Table{
    Row{1, Luminance, Format::Luminance8},
    Row{2, LuminanceAlpha, Format::LuminanceAlpha8},
    Row{3, Rgb, Format::Rgbx8},
    Row{4, Rgba, Format::Rgba8},

    Row{GL_ALPHA, Alpha, Format::Alpha8},
    Row{GL_ALPHA4, Alpha, Format::Alpha8},
    Row{GL_ALPHA8, Alpha, Format::Alpha8},
    Row{GL_ALPHA12, Alpha, Format::Alpha8},
    Row{GL_ALPHA16, Alpha, Format::Alpha8},
    Row{GL_LUMINANCE, Luminance, Format::Luminance8},
    Row{GL_LUMINANCE4, Luminance, Format::Luminance8},
    Row{GL_LUMINANCE8, Luminance, Format::Luminance8},
    Row{GL_LUMINANCE12, Luminance, Format::Luminance8},
    Row{GL_LUMINANCE16, Luminance, Format::Luminance8},
    Row{GL_LUMINANCE_ALPHA, LuminanceAlpha, Format::LuminanceAlpha8},
    Row{GL_LUMINANCE4_ALPHA4, LuminanceAlpha, Format::LuminanceAlpha8},
    Row{GL_LUMINANCE6_ALPHA2, LuminanceAlpha, Format::LuminanceAlpha8},
    Row{GL_LUMINANCE8_ALPHA8, LuminanceAlpha, Format::LuminanceAlpha8},
    Row{GL_LUMINANCE12_ALPHA4, LuminanceAlpha, Format::LuminanceAlpha8},
    Row{GL_LUMINANCE12_ALPHA12, LuminanceAlpha, Format::LuminanceAlpha8},
    Row{GL_LUMINANCE16_ALPHA16, LuminanceAlpha, Format::LuminanceAlpha8},
    Row{GL_INTENSITY, Intensity, Format::Intensity8},
    Row{GL_INTENSITY4, Intensity, Format::Intensity8},
    Row{GL_INTENSITY8, Intensity, Format::Intensity8},
    Row{GL_INTENSITY12, Intensity, Format::Intensity8},
    Row{GL_INTENSITY16, Intensity, Format::Intensity8},
    Row{GL_RGB, Rgb, Format::Rgbx8},
    Row{GL_R3_G3_B2, Rgb, Format::Rgb565},
    Row{GL_RGB4, Rgb, Format::Rgb565},
    Row{GL_RGB5, Rgb, Format::Rgb565},
    Row{GL_RGB565, Rgb, Format::Rgb565},
    Row{GL_RGB8, Rgb, Format::Rgbx8},
    Row{GL_RGB10, Rgb, Format::Rgbx8},
    Row{GL_RGB12, Rgb, Format::Rgbx8},
    Row{GL_RGB16, Rgb, Format::Rgbx8},
    Row{GL_RGBA, Rgba, Format::Rgba8},
    Row{GL_RGBA2, Rgba, Format::Rgba4},
    Row{GL_RGBA4, Rgba, Format::Rgba4},
    Row{GL_RGB5_A1, Rgba, Format::Rgb5a1},
    Row{GL_RGBA8, Rgba, Format::Rgba8},
    Row{GL_RGB10_A2, Rgba, Format::Rgba8},
    Row{GL_RGBA12, Rgba, Format::Rgba8},
    Row{GL_RGBA16, Rgba, Format::Rgba8},

    Row{GL_DEPTH_COMPONENT, Depth, Format::Depth24Stencil8},
    Row{GL_DEPTH_COMPONENT16, Depth, Format::Depth16},
    Row{GL_DEPTH_COMPONENT24, Depth, Format::Depth24Stencil8},
    Row{GL_DEPTH_COMPONENT32, Depth, Format::Depth24Stencil8},
    Row{GL_DEPTH_STENCIL, DepthStencil, Format::Depth24Stencil8},
    Row{GL_DEPTH24_STENCIL8, DepthStencil, Format::Depth24Stencil8},

    Row{GL_COMPRESSED_ALPHA, Alpha, Format::Alpha8},
    Row{GL_COMPRESSED_LUMINANCE, Luminance, Format::Luminance8},
    Row{GL_COMPRESSED_LUMINANCE_ALPHA, LuminanceAlpha, Format::LuminanceAlpha8},
    Row{GL_COMPRESSED_INTENSITY, Intensity, Format::Intensity8},
    Row{GL_COMPRESSED_RGB, Rgb, Format::Rgbx8},
    Row{GL_COMPRESSED_RGBA, Rgba, Format::Rgba8},
    Row{GL_COMPRESSED_RGB_S3TC_DXT1_EXT, Rgb, Format::Dxt1Rgb},
    Row{GL_COMPRESSED_RGBA_S3TC_DXT1_EXT, Rgba, Format::Dxt1Rgba},
    Row{GL_COMPRESSED_RGBA_S3TC_DXT3_EXT, Rgba, Format::Dxt3},
    Row{GL_COMPRESSED_RGBA_S3TC_DXT5_EXT, Rgba, Format::Dxt5},
    Row{GL_COMPRESSED_RGB_FXT1_3DFX, Rgb, Format::Fxt1Rgb},
    Row{GL_COMPRESSED_RGBA_FXT1_3DFX, Rgba, Format::Fxt1Rgba},

    Row{GL_SRGB, Rgb, Format::Rgbx8, true},
    Row{GL_SRGB8, Rgb, Format::Rgbx8, true},
    Row{GL_SRGB_ALPHA, Rgba, Format::Rgba8, true},
    Row{GL_SRGB8_ALPHA8, Rgba, Format::Rgba8, true},
    Row{GL_SLUMINANCE, Luminance, Format::Luminance8, true},
    Row{GL_SLUMINANCE8, Luminance, Format::Luminance8, true},
    Row{GL_SLUMINANCE_ALPHA, LuminanceAlpha, Format::LuminanceAlpha8, true},
    Row{GL_SLUMINANCE8_ALPHA8, LuminanceAlpha, Format::LuminanceAlpha8, true},
    Row{GL_COMPRESSED_SRGB, Rgb, Format::Rgbx8, true},
    Row{GL_COMPRESSED_SRGB_ALPHA, Rgba, Format::Rgba8, true},
    Row{GL_COMPRESSED_SLUMINANCE, Luminance, Format::Luminance8, true},
    Row{GL_COMPRESSED_SLUMINANCE_ALPHA, LuminanceAlpha, Format::LuminanceAlpha8, true},
    Row{GL_COMPRESSED_SRGB_S3TC_DXT1_EXT, Rgb, Format::Dxt1Rgb, true},
    Row{GL_COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT, Rgba, Format::Dxt1Rgba, true},
    Row{GL_COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT, Rgba, Format::Dxt3, true},
    Row{GL_COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT, Rgba, Format::Dxt5, true},
};

} // namespace

InternalFormat texture_format(GLenum internal_format) {
    const auto named = [&](const Row& row) { return row.token == internal_format; };
    const auto row = std::find_if(Table.begin(), Table.end(), named);
    return row == Table.end() ? InternalFormat{}
                              : InternalFormat{row->base, row->format, row->srgb};
}

InternalFormat renderbuffer_format(GLenum internal_format) {
    switch (internal_format) {
    case GL_STENCIL_INDEX:
    case GL_STENCIL_INDEX1:
    case GL_STENCIL_INDEX4:
    case GL_STENCIL_INDEX8:
    case GL_STENCIL_INDEX16:
        return {Stencil, Format::Depth24Stencil8};
    default:
        break;
    }
    const InternalFormat format = texture_format(internal_format);
    const bool compressed = queried_format(internal_format) != internal_format ||
                            is_specific_compressed(internal_format);
    return compressed || internal_format <= 4 ? InternalFormat{} : format;
}

ComponentBits component_bits(InternalFormat format) {
    switch (format.base) {
    case Alpha:
        return {.alpha = 8};
    case Luminance:
        return {.luminance = 8};
    case LuminanceAlpha:
        return {.alpha = 8, .luminance = 8};
    case Intensity:
        return {.intensity = 8};
    case Depth:
        return {.depth = static_cast<std::uint8_t>(format.format == Format::Depth16 ? 16 : 24)};
    case DepthStencil:
        return {.depth = 24, .stencil = 8};
    case Stencil:
        return {.stencil = 8};
    default:
        break;
    }
    switch (format.format) {
    case Format::Rgba8:
        return {8, 8, 8, 8};
    case Format::Rgbx8:
        return {8, 8, 8, 0};
    case Format::Rgb565:
        return {5, 6, 5, 0};
    case Format::Rgba4:
        return {4, 4, 4, 4};
    case Format::Rgb5a1:
        return {5, 5, 5, 1};
    // Of compressed formats the components' resolution is an approximation (GL 1.5, 6.1.3).
    case Format::Dxt1Rgb:
    case Format::Fxt1Rgb:
        return {5, 6, 5, 0};
    case Format::Dxt1Rgba:
        return {5, 6, 5, 1};
    case Format::Dxt3:
        return {5, 6, 5, 4};
    case Format::Dxt5:
        return {5, 6, 5, 8};
    case Format::Fxt1Rgba:
        return {5, 5, 5, 5};
    default:
        return {};
    }
}

GLenum queried_format(GLenum internal_format) {
    switch (internal_format) {
    case GL_COMPRESSED_ALPHA:
        return GL_ALPHA;
    case GL_COMPRESSED_LUMINANCE:
    case GL_COMPRESSED_SLUMINANCE:
        return GL_LUMINANCE;
    case GL_COMPRESSED_LUMINANCE_ALPHA:
    case GL_COMPRESSED_SLUMINANCE_ALPHA:
        return GL_LUMINANCE_ALPHA;
    case GL_COMPRESSED_INTENSITY:
        return GL_INTENSITY;
    case GL_COMPRESSED_RGB:
    case GL_COMPRESSED_SRGB:
        return GL_RGB;
    case GL_COMPRESSED_RGBA:
    case GL_COMPRESSED_SRGB_ALPHA:
        return GL_RGBA;
    default:
        return internal_format;
    }
}

bool is_compressed(Format format) {
    return format_info(format).block_width > 1;
}

bool is_fxt1(Format format) {
    return format == Format::Fxt1Rgb || format == Format::Fxt1Rgba;
}

bool is_specific_compressed(GLenum internal_format) {
    return is_compressed(texture_format(internal_format).format);
}

bool is_renderable(Format format) {
    const bool plain_color = format >= Format::Rgba8 && format <= Format::Rgb5a1;
    return plain_color || format_info(format).is_depth;
}

} // namespace ffgpu::gl
