// Which attributes a draw's fragments need, and where they stand in a WindowVertex.

#pragma once

#include "model/device/layout/limits.h"

#include <array>
#include <cstdint>

namespace ffgpu {

constexpr unsigned MaxInterpolants = 4 + 4 + 1 + 4 * TextureUnits;

// Offsets into WindowVertex::attributes, in floats; -1: not carried. Colours are 4 floats
// (secondary: r g b), texture coordinates are `tex_components` floats: s t (2), s t r (3) or
// s t r q (4); a coordinate that is not carried is 0, q is 1.
struct InterpolantLayout {
    std::int8_t color = -1;
    std::int8_t secondary = -1;
    std::int8_t fog = -1;
    std::array<std::int8_t, TextureUnits> tex_coord{-1, -1, -1, -1, -1, -1, -1, -1};
    std::array<std::uint8_t, TextureUnits> tex_components{};
    std::uint8_t count = 0;

    bool operator==(const InterpolantLayout&) const = default;
};

} // namespace ffgpu
