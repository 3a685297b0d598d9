// The planes of a primitive: depth exact in 64-bit integers, attributes in block floating point.

#pragma once

#include "model/raster/attribute_setup.h"
#include "model/raster/setup.h"

#include <array>

namespace ffgpu {

using PlaneVertices = std::array<const WindowVertex*, 3>;

PlaneBasis triangle_basis(const PlaneVertices& vertices);
PlaneBasis line_basis(const WindowVertex& from, const WindowVertex& to);

// From which vertices, and how, the planes of a primitive follow.
struct PlaneGeometry {
    PlaneVertices vertices;
    AttributeFrame attributes;
    // Attributes follow from the edge between the first two vertices, depth from all three.
    bool sliver = false;

    PlaneBasis depth() const { return sliver ? triangle_basis(vertices) : attributes.basis; }
};

// Triangles less than 1/256 pixel high have their attributes from their longest edge alone.
PlaneGeometry triangle_geometry(const PlaneVertices& vertices);
// Of a line `width` pixels wide.
PlaneGeometry line_geometry(const WindowVertex& from, const WindowVertex& to, float width);
PlaneGeometry point_geometry(const WindowVertex& vertex);

// triangle_geometry() and set_up_planes() in one.
void set_up_triangle_planes(const SetupContext& context,
                            const PlaneVertices& vertices,
                            SetupRecord& record);

// Fills reference pixel, depth, inverse_w, constant colours and all attribute planes of `record`.
void set_up_planes(const SetupContext& context, const PlaneGeometry& geometry, SetupRecord& record);

// A colour, clamped to [0, 1], to 0 .. 255; halves up.
std::uint8_t color_byte(float color);

// SetupRecord::divided_units.
std::uint8_t divided_units(const PlaneVertices& vertices, const InterpolantLayout& layout);

// Adds GL 1.5's (3.5.5) m * factor + r * units, m being the steeper of the basis' depth steps.
void add_depth_offset(const SetupContext& context,
                      const PlaneVertices& slope_vertices,
                      const PlaneBasis& basis,
                      SetupRecord& record);

} // namespace ffgpu
