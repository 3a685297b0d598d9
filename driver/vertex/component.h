// How the numbers of vertex commands and arrays become floats (GL 1.5, table 2.6).

#pragma once

#include "driver/gl_types.h"
#include "driver/math/conversion.h"

#include <array>
#include <type_traits>

namespace ffgpu::gl {

namespace detail {
constexpr std::array<float, 256> UnsignedByteToUnit = [] {
    std::array<float, 256> table{};
    for (unsigned i = 0; i < 256; ++i)
        table[i] = static_cast<float>(i) / 255.0f;
    return table;
}();
} // namespace detail

// As it is: positions, texture coordinates, fog coordinates.
template <class Number>
constexpr float plain(Number value) {
    return static_cast<float>(value);
}

// Colours and normals: integers map to [0, 1], c / (2^b - 1), or if signed to [-1, 1],
// (2 c + 1) / (2^b - 1). Floats stay.
template <class Number>
constexpr float normalized(Number value) {
    if constexpr (std::is_floating_point_v<Number>) {
        return static_cast<float>(value);
    } else if constexpr (std::is_same_v<Number, GLubyte>) {
        return detail::UnsignedByteToUnit[value];
    } else if constexpr (std::is_same_v<Number, GLushort>) {
        return static_cast<float>(value) / 65535.0f;
    } else if constexpr (std::is_same_v<Number, GLuint>) {
        return static_cast<float>(static_cast<double>(value) / 4294967295.0);
    } else if constexpr (std::is_same_v<Number, GLbyte>) {
        return static_cast<float>(2 * value + 1) / 255.0f;
    } else if constexpr (std::is_same_v<Number, GLshort>) {
        return static_cast<float>(2 * value + 1) / 65535.0f;
    } else {
        static_assert(std::is_same_v<Number, GLint>);
        return normalized_from_int(value);
    }
}

} // namespace ffgpu::gl
