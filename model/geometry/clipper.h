// Clipper: cuts polygons and lines with the planes of the view volume and of the user, in
// homogeneous coordinates (GL 1.5, 2.11).
//
// It works in binary64 on positions alone. Of each vertex it makes it remembers between which two
// it lies and where, so that attributes can follow once it is known which side of the polygon is
// seen. A cut is always computed from the inner vertex to the outer one: an edge that two polygons
// share is cut at the same place in both.

#pragma once

#include "model/geometry/clip_code.h"
#include "model/geometry/vertex_setup.h"
#include "model/packets/window_vertex.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace ffgpu {

struct ClipVertex {
    std::array<double, 4> clip;
    std::array<double, 4> eye; // valid where user planes are enabled
    ClipCode depth_plane = 0;  // BeforeNear or BeyondFar: a cut at the plane of that name
    bool made = false;         // by a cut: from + t (to - from), numbers of vertices
    std::uint32_t slot = 0;    // else: of the vertex pool
    std::uint32_t from = 0, to = 0;
    double t = 0;
};

// A corner of a polygon: a vertex of the clipper, and whether the edge to the next one is a
// boundary edge.
struct ClipCorner {
    std::uint32_t vertex = 0;
    bool boundary = true;
};

class Clipper {
public:
    enum class Bounds {
        Polygon, // x and y to WindowSetup's limits
        Exact,   // x and y to the view volume
    };

    void start(const VertexSetup& setup);

    // Forgets all vertices.
    void clear() {
        vertices_.clear();
        planes_used_ = 0;
    }
    std::uint32_t add(std::uint32_t slot, const Vec4& clip, const Vec4& eye);
    const ClipVertex& vertex(std::uint32_t number) const { return vertices_[number]; }
    std::uint32_t vertex_count() const { return static_cast<std::uint32_t>(vertices_.size()); }

    // What is left of the polygon (less than three corners: nothing). `codes`: the union of its
    // vertices' clip codes. Valid until the next call.
    std::span<const ClipCorner>
    clip_polygon(std::span<const ClipCorner> polygon, ClipCode codes, Bounds bounds);

    // Where depth is clamped: the polygon or line with a corner wherever an edge passes the near or
    // far plane, so that clamped depth is linear along each edge. Valid as above.
    std::span<const ClipCorner> cut_at_depths(std::span<const ClipCorner> corners, ClipCode codes);
    // Whether the vertex is of the part before the near plane (BeforeNear), beyond the far plane
    // (BeyondFar), or between them (0). What lies on a plane is of both sides.
    bool is_of_part(std::uint32_t number, ClipCode part) const;

    // Planes against which anything was cut or tested since clear().
    unsigned planes_used() const { return planes_used_; }

    // False: nothing is left.
    bool clip_line(std::uint32_t& a, std::uint32_t& b, ClipCode codes);

    // Window coordinates; attributes are left alone.
    void project(std::uint32_t number, WindowVertex& vertex) const;

private:
    static constexpr unsigned MaxPlanes = 3 + ClipPlanes + 4;

    // Inside where dot(plane, clip or eye) + constant >= 0.
    struct Plane {
        std::array<double, 4> normal{};
        double constant = 0;
        bool in_eye_space = false;
    };

    double distance(const Plane& plane, std::uint32_t number) const;
    std::uint32_t
    cut(std::uint32_t inner, std::uint32_t outer, double inner_distance, double outer_distance);
    void cut_polygon(const Plane& plane);
    void cut_edges(std::span<const ClipCorner> corners, const Plane& plane, ClipCode name);
    std::span<const Plane> planes_for(ClipCode codes, Bounds bounds);

    const VertexSetup* setup_ = nullptr;
    std::vector<ClipVertex> vertices_;
    std::vector<ClipCorner> polygon_, next_;
    std::array<Plane, MaxPlanes> planes_;
    unsigned planes_used_ = 0;
};

} // namespace ffgpu
