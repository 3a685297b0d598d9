// Four colour components as one word, red in the lowest byte.

#pragma once

#include "driver/math/conversion.h"

#include <array>
#include <cstdint>

namespace ffgpu::gl {

constexpr std::uint32_t pack_rgba8(const std::array<float, 4>& color) {
    return unorm(color[0], 8) | unorm(color[1], 8) << 8 | unorm(color[2], 8) << 16 |
           unorm(color[3], 8) << 24;
}
static_assert(pack_rgba8({1, 0, 0, 0.5f}) == 0x800000ff);

} // namespace ffgpu::gl
