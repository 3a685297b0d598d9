// What GL's internal formats (GL 1.5, tables 3.15 to 3.17) become on the device.

#pragma once

#include "driver/gl_types.h"
#include "model/device/layout/formats.h"

#include <cstdint>

namespace ffgpu::gl {

enum class BaseFormat : std::uint8_t {
    None,
    Alpha,
    Luminance,
    LuminanceAlpha,
    Intensity,
    Rgb,
    Rgba,
    Depth,
    DepthStencil,
    Stencil, // renderbuffers only
};

// Bits of each component, as glGetTexLevelParameter reports them.
struct ComponentBits {
    std::uint8_t red = 0, green = 0, blue = 0, alpha = 0;
    std::uint8_t luminance = 0, intensity = 0;
    std::uint8_t depth = 0, stencil = 0;
};

struct InternalFormat {
    BaseFormat base = BaseFormat::None;
    Format format = Format::None;
    bool srgb = false; // red, green and blue are sRGB codes (EXT_texture_sRGB)
};

// base None: GL does not know it as a texture's internal format. Formats wider than the device's
// are stored in 8 bits a channel; generic compressed formats are stored uncompressed.
InternalFormat texture_format(GLenum internal_format);

// The same of a renderbuffer, where stencil indices are formats too and compressed ones are not.
InternalFormat renderbuffer_format(GLenum internal_format);

ComponentBits component_bits(InternalFormat format);

// The internal format that a query returns: of generic compressed formats, which are stored
// uncompressed, the base internal format (ARB_texture_compression); of sRGB ones too.
GLenum queried_format(GLenum internal_format);

bool is_compressed(Format format); // S3TC or FXT1
bool is_fxt1(Format format);
bool is_specific_compressed(GLenum internal_format); // the same of GL's name; not generic ones
bool is_renderable(Format format);                   // as a colour, depth or stencil attachment

} // namespace ffgpu::gl
