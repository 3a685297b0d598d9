// Set-up of attribute planes: values at three vertices become integers with one exponent, and
// gradients that are exact quotients, rounded once (docs/arithmetic/raster.md).

#pragma once

#include "model/packets/interpolants.h"
#include "model/raster/attribute_plane.h"

#include <array>
#include <cstdint>

namespace ffgpu {

// How a plane's steps follow from its values at the vertices, per pixel:
//     dx = ((v1 - v0) x1 + (v2 - v0) x2) 256 / divisor,
//     dy = ((v1 - v0) y1 + (v2 - v0) y2) 256 / divisor.
// A line has v2 = v0, a point v2 = v1 = v0.
struct PlaneBasis {
    std::int32_t x1 = 0, x2 = 0, y1 = 0, y2 = 0; // 1/256 pixel
    std::int64_t divisor = 1;                    // positive
};

// From vertex 0 to the centre of the reference pixel, in 1/256 pixel.
struct ReferenceOffset {
    std::int32_t x, y;
};

struct AttributeFrame {
    PlaneBasis basis;
    ReferenceOffset offset;
    // How many pixels in x and in y a lane of a touched quad may lie from where the primitive's
    // values are those between its vertices'.
    int reach = 2;
};

// Vertex integers are below 2^ValueBits in magnitude, lanes below 2^31.
constexpr int ValueBits = 29;
// The exponent of all smaller values: below 2^(LeastExponent - ValueBits - 1) they are 0.
constexpr int LeastExponent = -40;

struct BlockPlane {
    std::int64_t c = 0, dx = 0, dy = 0; // AttributePlane
    int exponent = 0;                   // an integer of 2^ValueBits stands for 2^exponent
};

// The specification, for one attribute with these values at the vertices.
BlockPlane set_up_block_plane(const std::array<double, 3>& values, const AttributeFrame& frame);

// Values at the vertices, an array a vertex.
struct VertexValues {
    static constexpr unsigned Capacity = (MaxInterpolants + 8) & ~3u;

    alignas(64) std::array<std::array<double, Capacity>, 3> of;
};

struct BlockPlanes {
    alignas(64) std::array<std::int64_t, VertexValues::Capacity> c, dx, dy, exponent;
};

// The same for the first `count` of many; the values behind them, up to a multiple of 4, are read
// as well.
void set_up_block_planes(const VertexValues& values,
                         unsigned count,
                         const AttributeFrame& frame,
                         BlockPlanes& planes);

} // namespace ffgpu
