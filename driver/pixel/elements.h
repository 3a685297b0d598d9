// Elements of pixels in the application's memory: loads and stores with byte swapping, and the
// conversions of GL 1.5's tables 2.6 and 4.7.

#pragma once

#include "driver/gl_types.h"
#include "driver/math/conversion.h"
#include "driver/math/half.h"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

namespace ffgpu::gl {

template <class T>
T swap_bytes(T value) {
    if constexpr (sizeof(T) == 2) {
        return std::bit_cast<T>(__builtin_bswap16(std::bit_cast<std::uint16_t>(value)));
    } else if constexpr (sizeof(T) == 4) {
        return std::bit_cast<T>(__builtin_bswap32(std::bit_cast<std::uint32_t>(value)));
    } else {
        static_assert(sizeof(T) == 1);
        return value;
    }
}

template <class T>
T load_element(const std::byte* at, bool swap) {
    T value;
    std::memcpy(&value, at, sizeof value);
    return swap ? swap_bytes(value) : value;
}

template <class T>
void store_element(std::byte* at, T value, bool swap) {
    if (swap) value = swap_bytes(value);
    std::memcpy(at, &value, sizeof value);
}

// An integer's range to [0, 1] or [-1, 1]; floats as they are.
template <class T>
constexpr double real_from_element(T value) {
    if constexpr (std::is_same_v<T, Half>) {
        return real_from_half(value);
    } else if constexpr (std::is_floating_point_v<T>) {
        return static_cast<double>(value);
    } else if constexpr (std::is_unsigned_v<T>) {
        return value / static_cast<double>(std::numeric_limits<T>::max());
    } else {
        constexpr double Range = std::numeric_limits<std::make_unsigned_t<T>>::max();
        return (2.0 * value + 1.0) / Range;
    }
}

// From [0, 1]; values beyond are clamped to it.
template <class T>
constexpr T element_from_real(double value) {
    const double real = clamp_unit(value);
    if constexpr (std::is_same_v<T, Half>) {
        return half_from_real(real);
    } else if constexpr (std::is_floating_point_v<T>) {
        return static_cast<T>(real);
    } else if constexpr (std::is_unsigned_v<T>) {
        return static_cast<T>(real * static_cast<double>(std::numeric_limits<T>::max()) + 0.5);
    } else {
        constexpr double Range = std::numeric_limits<std::make_unsigned_t<T>>::max();
        return static_cast<T>((Range * real - 1.0) / 2.0 + (real > 0 ? 0.5 : 0.0));
    }
}

// Indices: the integer part; beyond the type's range, its lowest bits (GL 1.5, table 4.6).
template <class T>
constexpr std::int32_t index_from_element(T value) {
    if constexpr (std::is_floating_point_v<T> || std::is_same_v<T, Half>) {
        const double real = real_from_element(value);
        if (!(real > -2147483648.0)) return real < 0 ? std::numeric_limits<std::int32_t>::min() : 0;
        if (real >= 2147483647.0) return std::numeric_limits<std::int32_t>::max();
        return static_cast<std::int32_t>(real);
    } else {
        return static_cast<std::int32_t>(value);
    }
}

template <class T>
constexpr T element_from_index(std::int32_t index) {
    if constexpr (std::is_same_v<T, Half>) {
        return half_from_real(index);
    } else if constexpr (std::is_floating_point_v<T>) {
        return static_cast<T>(index);
    } else {
        return static_cast<T>(index & static_cast<std::int32_t>(std::numeric_limits<T>::max()));
    }
}

// Calls visitor with a value of the C++ type behind an unpacked GL type; GL_FLOAT for others.
template <class Visitor>
decltype(auto) with_element_type(GLenum type, Visitor&& visitor) {
    switch (type) {
    case GL_BYTE:
        return visitor(std::int8_t{});
    case GL_UNSIGNED_BYTE:
        return visitor(std::uint8_t{});
    case GL_SHORT:
        return visitor(std::int16_t{});
    case GL_UNSIGNED_SHORT:
        return visitor(std::uint16_t{});
    case GL_INT:
        return visitor(std::int32_t{});
    case GL_UNSIGNED_INT:
        return visitor(std::uint32_t{});
    case GL_HALF_FLOAT:
        return visitor(Half{});
    default:
        return visitor(float{});
    }
}

// The word of a packed type of `bytes` bytes.
inline std::uint32_t load_packed(const std::byte* at, unsigned bytes, bool swap) {
    if (bytes == 1) return load_element<std::uint8_t>(at, swap);
    if (bytes == 2) return load_element<std::uint16_t>(at, swap);
    return load_element<std::uint32_t>(at, swap);
}

inline void store_packed(std::byte* at, unsigned bytes, std::uint32_t word, bool swap) {
    if (bytes == 1) return store_element(at, static_cast<std::uint8_t>(word), swap);
    if (bytes == 2) return store_element(at, static_cast<std::uint16_t>(word), swap);
    store_element(at, word, swap);
}

} // namespace ffgpu::gl
