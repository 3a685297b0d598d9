// Arithmetic of 8-bit unsigned normalised values: 255 stands for 1.

#pragma once

#include <algorithm>
#include <cstdint>

namespace ffgpu {

constexpr std::uint32_t Unorm8One = 255;
constexpr std::uint32_t Unorm8OneSquared = 255 * 255; // 1 in the units of a product

// round(product / 255) for product <= 65025, without a division. There are no ties: 255 is odd.
constexpr std::uint32_t divide_255(std::uint32_t product) {
    const std::uint32_t t = product + 128;
    return (t + (t >> 8)) >> 8;
}

constexpr std::uint8_t multiply_unorm8(std::uint32_t a, std::uint32_t b) {
    return static_cast<std::uint8_t>(divide_255(a * b));
}

// round(product / 255) after a clamp to [0, 1].
constexpr std::uint8_t unorm8_from_product(std::int32_t product) {
    return static_cast<std::uint8_t>(divide_255(static_cast<std::uint32_t>(
        std::clamp(product, 0, static_cast<std::int32_t>(Unorm8OneSquared)))));
}

} // namespace ffgpu
