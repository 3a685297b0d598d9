// The formats and types of pixels in the application's memory (GL 1.5, tables 3.5, 3.6 and 3.8).

#pragma once

#include "driver/gl_types.h"

#include <array>
#include <cstdint>

namespace ffgpu::gl {

enum class PixelKind : std::uint8_t { Color, Index, Stencil, Depth, DepthStencil };

// Components in memory: entry i is the channel (0 red .. 3 alpha) of component i. Luminance is read
// as red, green and blue.
struct ComponentOrder {
    PixelKind kind = PixelKind::Color;
    std::uint8_t count = 0; // 0: GL does not know the format
    std::array<std::uint8_t, 4> channel{};
    bool luminance = false;
};

ComponentOrder component_order(GLenum format);

// A packed type's fields from component 0 on, lowest bit and width; count 0: not packed.
struct PackedType {
    struct Field {
        std::uint8_t shift, bits;
    };
    std::uint8_t count = 0;
    std::uint8_t bytes = 0;
    std::array<Field, 4> fields{};
};

PackedType packed_type(GLenum type);

// Bytes of an element: of a component, or of a pixel of a packed type. 0: GL does not know the
// type; GL_BITMAP has 1.
unsigned type_bytes(GLenum type);

// Bytes of a pixel; not of GL_BITMAP.
unsigned pixel_bytes(GLenum format, GLenum type);

// GL_NO_ERROR, or the error of this combination in a command that knows all formats. Commands that
// take fewer formats check them first.
GLenum format_type_error(GLenum format, GLenum type);

} // namespace ffgpu::gl
