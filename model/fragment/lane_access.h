// One lane of a FragmentBatch, as the scalar forms see it.

#pragma once

#include "model/memory/pixel_format.h"
#include "model/packets/fragment_batch.h"

#include <cstdint>

namespace ffgpu {

inline PixelColor lane_color(const ColorPlanes& planes, unsigned lane) {
    const auto byte = [&](std::uint16_t value) { return static_cast<std::uint8_t>(value); };
    return {byte(planes.r[lane]), byte(planes.g[lane]), byte(planes.b[lane]), byte(planes.a[lane])};
}

inline void set_lane_color(ColorPlanes& planes, unsigned lane, const PixelColor& color) {
    planes.r[lane] = color[0];
    planes.g[lane] = color[1];
    planes.b[lane] = color[2];
    planes.a[lane] = color[3];
}

// Pixel of the window.
struct LanePosition {
    std::uint32_t x, y;
};

inline LanePosition lane_position(const FragmentBatch& batch, unsigned lane) {
    return {batch.x[lane / 4] + (lane & 1), batch.y[lane / 4] + (lane >> 1 & 1)};
}

inline bool lane_front_facing(const FragmentBatch& batch, unsigned lane) {
    const unsigned quad = lane / 4;
    return (batch.front_facing[quad / 64] >> (quad % 64) & 1) != 0;
}

} // namespace ffgpu
