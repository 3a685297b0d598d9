// SurfaceFill: what a clear does to the pixels of a surface.

#pragma once

#include "model/memory/pixel_fill.h"
#include "model/packets/rectangle.h"
#include "model/work/address_map.h"

namespace ffgpu::work {

struct SurfaceFill : PixelFill {
    PlacedLevel place{};
    Rectangle rectangle{}; // cut to the surface
};

} // namespace ffgpu::work
