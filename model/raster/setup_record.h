// SetupRecord: a primitive after set-up, all that traversal and interpolation need. Whatever its
// shape was, it is now the pixels of a box that lie inside up to four edges.
//
// Records stand one after another in a bin's arena; behind each stand its attribute planes.

#pragma once

#include "model/packets/interpolants.h"
#include "model/packets/rectangle.h"
#include "model/raster/edge.h"
#include "model/raster/stored_plane.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace ffgpu {

constexpr unsigned MaxEdges = 4;

// Depth in units of the depth target with 24 fraction bits, at the centre of the reference pixel,
// and its exact steps to the next pixel.
struct DepthPlane {
    static constexpr int FractionBits = 24;

    std::int64_t origin = 0, dx = 0, dy = 0;

    // What a point `by` (1/256 pixel) beside a centre has more, to nearest.
    std::int64_t beside(SubPixelPoint by) const {
        return (dx * by.x + dy * by.y + (1 << (SubPixelBits - 1))) >> SubPixelBits;
    }

    // Modulo 2^64; x and y are relative to the reference pixel.
    std::int64_t at(int x, int y) const {
        const auto step = [](std::int64_t by, int n) {
            return static_cast<std::uint64_t>(by) * static_cast<std::uint64_t>(std::int64_t{n});
        };
        return static_cast<std::int64_t>(static_cast<std::uint64_t>(origin) + step(dx, x) +
                                         step(dy, y));
    }
};

enum class CoverageKind : std::uint8_t {
    Centre,        // Pixels whose centre lies inside the edges.
    SmoothPolygon, // The area of each pixel that lies inside the corners.
    SmoothPoint,   // The same for a circle.
    Samples,       // Samples that lie inside the edges: multisampled targets.
    SamplePoint,   // Samples that lie inside a circle.
};

enum class StippleKind : std::uint8_t { None, Polygon, LineX, LineY };

struct alignas(StoredPlane) SetupRecord {
    Rectangle box; // Never empty; inside scissor and targets.
    std::array<Edge, MaxEdges> edges;
    std::uint8_t edge_count = 0;
    CoverageKind coverage = CoverageKind::Centre;
    StippleKind stipple = StippleKind::None;
    bool front_facing = true;
    bool covers_nothing = false;     // Known of small triangles only.
    bool perspective = false;        // Attribute planes hold a / w; that of 1 / w is behind them.
    bool constant_color = false;     // All vertices alike: `color` is the value itself.
    bool constant_secondary = false; // The same.
    std::uint8_t plane_count = 0;
    std::uint8_t divided_units = 0; // A bit a texture unit whose q is not 1 at every vertex.
    std::array<std::uint8_t, 4> color{}, secondary{}; // r g b a, 0 .. 255
    std::uint32_t key = 0;                            // PrimitiveKey::primitive
    // How many primitives with this key came to set-up before: clipped pieces, the triangles of a
    // polygon, the lines or points of its outline.
    std::uint32_t piece = 0;

    int x_reference = 0, y_reference = 0;
    std::array<std::uint8_t, MaxEdges> edge_fractions; // Samples: ExactEdge::fraction
    DepthPlane depth;
    std::uint32_t depth_min = 0, depth_max = 0; // Of the vertices: no fragment lies outside.
    std::int32_t inverse_w_floor = 1; // Half the smallest vertex: below it 1/w is not believed.

    // Line stipple: the counter's value at pixel stipple_start of the major axis, and whether it
    // counts up or down from there.
    std::int32_t stipple_start = 0;
    std::int32_t stipple_direction = 1;
    std::uint16_t stipple_counter = 0;

    // SmoothPolygon: corners, counter-clockwise. SmoothPoint and SamplePoint: corner 0 the centre,
    // corner 1.x the radius.
    std::array<SubPixelPoint, MaxEdges> corners;

    void set_edge(unsigned i, const ExactEdge& edge) {
        edges[i] = edge.edge;
        edge_fractions[i] = edge.fraction;
    }
    ExactEdge exact_edge(unsigned i) const { return {edges[i], edge_fractions[i]}; }

    // Planes by InterpolantLayout, and with perspective that of 1 / w, to whose exponent those of
    // the others relate.
    const StoredPlane* planes() const { return reinterpret_cast<const StoredPlane*>(this + 1); }
    StoredPlane* planes() { return reinterpret_cast<StoredPlane*>(this + 1); }
    AttributePlane plane(unsigned i) const { return planes()[i].plane(); }
    AttributePlane inverse_w() const { return plane(plane_count); }

    std::size_t bytes() const { return bytes_for(plane_count + std::size_t{perspective}); }
    static constexpr std::size_t bytes_for(std::size_t planes) {
        return sizeof(SetupRecord) + planes * sizeof(StoredPlane);
    }
};

constexpr std::size_t MaxSetupRecordBytes = SetupRecord::bytes_for(PlaneRoom);

} // namespace ffgpu
