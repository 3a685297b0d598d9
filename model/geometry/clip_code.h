// Clip codes: on which sides of the clipping planes a vertex lies.

#pragma once

#include "model/device/layout/limits.h"

#include <cstdint>

namespace ffgpu {

using ClipCode = std::uint32_t;

// A set bit: the vertex is outside.
namespace clip_code {
constexpr ClipCode Left = 1, Right = 2, Bottom = 4, Top = 8; // of the view volume
constexpr ClipCode Near = 16, Far = 32;
constexpr ClipCode View = 63;
constexpr unsigned FirstUserBit = 6;
constexpr ClipCode User = ((1u << ClipPlanes) - 1) << FirstUserBit;
constexpr ClipCode Sides = 1u << 12;   // of the box to which polygons are clipped in x and y
constexpr ClipCode SmallW = 1u << 13;  // w below LeastW
constexpr ClipCode Invalid = 1u << 14; // a coordinate is not finite or too large: no primitive
// In place of Near and Far where depth is clamped.
constexpr ClipCode BeforeNear = 1u << 15, BeyondFar = 1u << 16;
constexpr ClipCode Clamped = BeforeNear | BeyondFar;

constexpr ClipCode Outside = View | User; // common to all: nothing is left
constexpr ClipCode CutsPolygon = Near | Far | User | Sides | SmallW;
constexpr ClipCode CutsLine = View | User | Sides | SmallW;
} // namespace clip_code

// Every number that leaves the unit has a magnitude below Largest; 1/w is at most 1 / LeastW.
constexpr float LargestMagnitude = 0x1p60f;
constexpr float LeastW = 0x1p-60f;

} // namespace ffgpu
