// Set-up of attribute planes: values at three vertices become integers with one exponent, and
// gradients that are exact quotients, rounded once (docs/arithmetic/raster.md).

#pragma once

#include "model/packets/interpolants.h"
#include "model/raster/stored_plane.h"

#include <array>
#include <cstdint>

namespace ffgpu {

// How a plane's steps follow from its values at the vertices, per pixel:
//     dx = ((v1 - v0) x1 + (v2 - v0) x2) 256 / divisor,
//     dy = ((v1 - v0) y1 + (v2 - v0) y2) 256 / divisor.
// A line has v2 = v0, a point v2 = v1 = v0.
// All but the last are integers; binary64, as most of set-up multiplies in it.
struct PlaneBasis {
    double x1 = 0, x2 = 0, y1 = 0, y2 = 0; // 1/256 pixel
    double divisor = 1;                    // positive, below 2^47
    double per_divisor = 256;              // 256 / divisor, rounded: the one division of set-up
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

// A primitive's attributes at its vertices, and what they are multiplied by.
struct AttributeValues {
    std::array<const float*, 3> of; // each vertex's, by the layout
    const InterpolantLayout& layout;
    bool perspective = false;
    std::array<double, 3> k{1, 1, 1}; // With perspective: the greatest is in [1, 2).

    // With perspective k is one more, behind the others.
    unsigned count() const { return layout.count + perspective; }
    // The exponent of k, unless it has to rise.
    int base_exponent() const { return perspective ? 1 : ValueBits; }
    // A bit for each attribute that is a colour's.
    std::uint64_t color_bits() const {
        const auto bits = [](int first, std::uint64_t channels) {
            return first < 0 ? 0 : channels << first;
        };
        return bits(layout.color, 0xf) | bits(layout.secondary, 7);
    }
    // a_j: colours times 255, all times k.
    std::array<double, 3> at(unsigned i) const;
};

// Sets up count() planes; there is room for PlaneRoom. Returns the exponent that is taken off those
// of all: k's with perspective, otherwise ValueBits.
int set_up_attributes(const AttributeValues& values,
                      const AttributeFrame& frame,
                      StoredPlane* planes);
int set_up_attributes_scalar(const AttributeValues& values,
                             const AttributeFrame& frame,
                             StoredPlane* planes);

// One of them.
StoredPlane set_up_attribute(const std::array<double, 3>& values,
                             const AttributeFrame& frame,
                             int base_exponent);

} // namespace ffgpu
