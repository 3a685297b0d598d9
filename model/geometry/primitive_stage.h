// PrimitiveStage: takes assembled primitives to the rasterizer: rejection, clipping, facing,
// culling, two-sided colours, polygon modes, flat shading, the line stipple's counter.
//
// Facing is decided on the vertices as they are snapped to the sub-pixel grid, so that it agrees
// with the rasterizer. Where both polygon modes are Fill, polygons come as triangles; else, and for
// feedback, they are taken whole, as their outline matters.

#pragma once

#include "model/device/registers/primitive.h"
#include "model/geometry/clipper.h"
#include "model/geometry/primitive_batch.h"
#include "model/geometry/primitive_output.h"
#include "model/geometry/vertex_pool.h"
#include "model/packets/work_stream.h"

#include <cstdint>
#include <span>
#include <vector>

namespace ffgpu {

// What became of a draw's primitives. A filled quad or polygon counts as its triangles.
struct PrimitiveCounts {
    std::uint32_t in = 0;
    std::uint32_t clipped = 0;
    std::uint32_t outside = 0;
    std::uint32_t culled = 0;
    std::uint32_t degenerate = 0;
};

// A corner of an assembled polygon: its vertex, and whether the edge to the next is a boundary.
struct PolygonCorner {
    std::uint32_t slot = 0;
    bool boundary = true;
};

class PrimitiveStage {
public:
    PrimitiveStage(VertexPool& pool, PrimitiveBatch& batch)
        : pool_(pool)
        , batch_(batch) {}

    // feedback: null for the rasterizer. work: null where nobody listens.
    void start(const VertexSetup& setup, FeedbackOutput* feedback, GeometryWork* work);

    // Polygons are wanted whole: call polygon() instead of triangle().
    bool whole_polygons() const { return whole_polygons_; }
    const PrimitiveCounts& counts() const { return counts_; }

    // The key of the primitives that follow, and the place in the draw of the last vertex that
    // they need; pieces of one share the key.
    void begin(std::uint32_t key, std::uint32_t last_vertex) {
        key_ = key;
        last_vertex_ = last_vertex;
    }
    void reset_line_stipple();
    // As it was made: the line stipple is at its beginning, though no draw has put it there.
    void reset();

    void point(std::uint32_t slot);
    // Provoking vertex: b.
    void line(std::uint32_t a, std::uint32_t b);
    void triangle(const std::array<std::uint32_t, 3>& slots, std::uint32_t provoking);
    void polygon(std::span<const PolygonCorner> corners, std::uint32_t provoking);

private:
    struct Codes {
        ClipCode any = 0, all = ~ClipCode{0};
        void add(ClipCode code) { any |= code, all &= code; }
        bool nothing_left() const {
            return (all & (clip_code::Outside | clip_code::SmallW)) != 0 ||
                   (any & clip_code::Invalid) != 0;
        }
        // Depth is clamped in a part only.
        bool parts_depth() const { return ((any ^ all) & clip_code::Clamped) != 0; }
    };
    struct Look { // how a primitive's vertices get their colours
        std::uint32_t provoking = 0;
        bool front_facing = true;
    };
    using Corners = std::span<const ClipCorner>;

    template <class Body>
    void record(Body&& body);
    void assembled_point(std::uint32_t slot);
    void assembled_line(std::uint32_t a, std::uint32_t b);
    void assembled_triangle(const std::array<std::uint32_t, 3>& slots, std::uint32_t provoking);
    void assembled_polygon(std::span<const PolygonCorner> corners, std::uint32_t provoking);
    bool culled(bool front_facing);
    void clipped_line(std::uint32_t a, std::uint32_t b, const Codes& codes);
    void clipped_triangle(const std::array<std::uint32_t, 3>& slots,
                          std::uint32_t provoking,
                          const Codes& codes);
    void emit_triangle(std::array<const WindowVertex*, 3> vertices, bool front_facing);
    void emit_outline(bool front_facing, bool counter_clockwise);

    std::uint32_t add_to_clipper(std::uint32_t slot) {
        return clipper_.add(slot, pool_.clip(slot), pool_.eye(slot));
    }
    std::int64_t project_corners(Corners corners);
    void finish_corners(Corners corners, Look look);
    void fill_outline(std::span<const PolygonCorner> corners, std::uint32_t provoking);
    void draw_outline(Corners corners, bool front_facing, PolygonMode mode);

    void emit_point(const WindowVertex& vertex, const Primitive& like);
    void emit_line(const WindowVertex& a, const WindowVertex& b, const Primitive& like);

    // Vertices with their final colours.
    const WindowVertex* shaded(std::uint32_t slot, Look look);
    const WindowVertex* with_colors_of(const WindowVertex& vertex, const WindowVertex& provoking);
    void shade_cuts(Look look);
    void interpolate(const ClipVertex& cut, WindowVertex& result) const;

    VertexPool& pool_;
    PrimitiveBatch& batch_;
    Clipper clipper_;
    FeedbackOutput* feedback_ = nullptr;
    GeometryWork* work_ = nullptr;

    PrimitiveSetup registers_;
    InterpolantLayout layout_;
    bool two_sided_ = false;
    bool plain_vertices_ = false; // Neither flat shading nor two sides: vertices as they are.
    bool whole_polygons_ = false;
    bool counts_stipple_ = false;

    std::uint32_t key_ = 0, last_vertex_ = 0;
    std::uint32_t stipple_counter_ = 0;
    bool stipple_was_reset_ = false;
    PrimitiveCounts counts_;

    std::vector<const WindowVertex*> shaded_; // of the clipper's vertices, by number
    std::vector<WindowVertex*> cuts_;         // the same, of those that a cut made
    std::vector<const WindowVertex*> outline_;
    std::vector<ClipCorner> corners_;
};

} // namespace ffgpu
