// What geometry hands to the rasterizer: vertices in window space, assembled into primitives.
//
// Clipping, culling, the viewport and polygon modes are behind; polygon offset, line and point
// shapes are the rasterizer's, which knows the slopes.

#pragma once

#include "model/packets/interpolants.h"

#include <array>
#include <cstdint>
#include <span>

namespace ffgpu {

struct WindowVertex {
    std::int32_t x = 0, y = 0; // 24.8 fixed point pixels, within +-GuardBand
    float depth = 0;           // window depth in [0, 1] (after the depth range)
    float inverse_w = 1;       // 1 / clip w, positive
    float point_size = 1;      // in pixels, after attenuation and clamps (points only)
    std::array<float, MaxInterpolants>
        attributes; // by the draw's InterpolantLayout; not divided by w
};

enum class PrimitiveShape : std::uint8_t { Point, Line, Triangle };

// Identity of a primitive in the work stream: draw counts DrawCommands and DrawImageCommands from
// the device's start; primitive counts within the draw, in the order of assembly, clipped pieces
// sharing the number of the primitive they were cut from.
struct PrimitiveKey {
    std::uint32_t draw = 0;
    std::uint32_t primitive = 0;

    auto operator<=>(const PrimitiveKey&) const = default;
};

struct Primitive {
    PrimitiveShape shape = PrimitiveShape::Triangle;
    bool front_facing = true;
    bool from_polygon = false; // a line or point of a polygon in its mode: its offset applies
    std::uint32_t key = 0;     // PrimitiveKey::primitive
    std::uint16_t stipple_counter = 0; // lines: the stipple counter s at the first vertex
    // 1, 2 or 3; with flat shading their colours are equal. A line or point from a polygon may
    // carry the polygon's other vertices behind its own, which give the slope for its depth offset.
    std::array<const WindowVertex*, 3> vertices{};
};

// The rasterizer's entrance. Vertices live until the call returns.
class PrimitiveSink {
public:
    virtual ~PrimitiveSink() = default;
    virtual void primitives(std::span<const Primitive> batch) = 0;
};

} // namespace ffgpu
