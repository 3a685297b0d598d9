// The planes of a primitive: depth exact in 64-bit integers, attributes in binary32.

#pragma once

#include "model/raster/setup.h"

#include <array>

namespace ffgpu {

// How a plane's steps follow from its values at the vertices, per pixel:
//     dx = (v1 - v0) x1 + (v2 - v0) x2,  dy = (v1 - v0) y1 + (v2 - v0) y2.
// A line has v2 = v0, a point v2 = v1 = v0.
struct PlaneBasis {
    double x1 = 0, x2 = 0, y1 = 0, y2 = 0;
};

using PlaneVertices = std::array<const WindowVertex*, 3>;

PlaneBasis triangle_basis(const PlaneVertices& vertices);
PlaneBasis line_basis(const WindowVertex& from, const WindowVertex& to);

// Fills reference pixel, depth, inverse_w and all attribute planes of `record`.
void set_up_planes(const SetupContext& context,
                   const PlaneVertices& vertices,
                   const PlaneBasis& basis,
                   SetupRecord& record);

// Adds GL 1.5's (3.5.5) m * factor + r * units, m being the steeper of the basis' depth steps.
void add_depth_offset(const SetupContext& context,
                      const PlaneVertices& slope_vertices,
                      const PlaneBasis& basis,
                      SetupRecord& record);

} // namespace ffgpu
