#include "model/geometry/primitive_stage.h"

namespace ffgpu {
namespace {

std::int64_t cross(const WindowVertex& a, const WindowVertex& b, const WindowVertex& c) {
    return std::int64_t{b.x - a.x} * (c.y - a.y) - std::int64_t{c.x - a.x} * (b.y - a.y);
}

} // namespace

void PrimitiveStage::start(const VertexSetup& setup, FeedbackOutput* feedback, GeometryWork* work) {
    registers_ = setup.registers->primitive;
    layout_ = setup.layout;
    feedback_ = feedback;
    work_ = work;
    two_sided_ = setup.needs_two_sides;
    plain_vertices_ = !two_sided_ && !registers_.flat_shading;
    whole_polygons_ = feedback != nullptr || registers_.front_mode != PolygonMode::Fill ||
                      registers_.back_mode != PolygonMode::Fill;
    counts_stipple_ = registers_.line_stipple;
    counts_ = {};
    clipper_.start(setup);
}

void PrimitiveStage::reset_line_stipple() {
    stipple_counter_ = 0;
    stipple_was_reset_ = true;
}

void PrimitiveStage::reset() {
    stipple_counter_ = 0;
    stipple_was_reset_ = false;
}

// Adds what became of a primitive to the draw's work. A polygon that went on as triangles has told
// theirs.
template <class Body>
void PrimitiveStage::record(Body&& body) {
    if (!work_) return body();
    const PrimitiveCounts before = counts_;
    const std::size_t recorded = work_->primitives.size();
    const std::uint64_t pieces = batch_.handed_over();
    clipper_.clear();
    body();
    if (work_->primitives.size() != recorded) return;
    PrimitiveWork primitive{.key = key_, .last_vertex = last_vertex_};
    primitive.pieces = static_cast<std::uint32_t>(batch_.handed_over() - pieces);
    primitive.planes = static_cast<std::uint8_t>(clipper_.planes_used());
    if (counts_.outside != before.outside)
        primitive.fate = PrimitiveFate::Outside;
    else if (counts_.culled != before.culled)
        primitive.fate = PrimitiveFate::Culled;
    else if (primitive.pieces == 0)
        primitive.fate = PrimitiveFate::Degenerate;
    work_->primitives.push_back(primitive);
}

void PrimitiveStage::point(std::uint32_t slot) {
    record([&] { assembled_point(slot); });
}

void PrimitiveStage::line(std::uint32_t a, std::uint32_t b) {
    record([&] { assembled_line(a, b); });
}

void PrimitiveStage::triangle(const std::array<std::uint32_t, 3>& slots, std::uint32_t provoking) {
    record([&] { assembled_triangle(slots, provoking); });
}

void PrimitiveStage::polygon(std::span<const PolygonCorner> corners, std::uint32_t provoking) {
    record([&] { assembled_polygon(corners, provoking); });
}

void PrimitiveStage::assembled_point(std::uint32_t slot) {
    using namespace clip_code;
    ++counts_.in;
    if (pool_.code(slot) & (CutsLine | Invalid)) {
        ++counts_.outside;
        return;
    }
    batch_.reserve(1, 0);
    emit_point(pool_.front(slot), {.key = key_});
}

void PrimitiveStage::assembled_line(std::uint32_t a, std::uint32_t b) {
    ++counts_.in;
    Codes codes;
    codes.add(pool_.code(a));
    codes.add(pool_.code(b));
    if (codes.nothing_left()) {
        ++counts_.outside;
        return;
    }
    if ((codes.any & clip_code::CutsLine) != 0 || codes.parts_depth())
        return clipped_line(a, b, codes);
    batch_.reserve(1, 4);
    const Look look{.provoking = b};
    emit_line(*shaded(a, look), *shaded(b, look), {.key = key_});
}

void PrimitiveStage::clipped_line(std::uint32_t a, std::uint32_t b, const Codes& codes) {
    clipper_.clear();
    std::uint32_t from = add_to_clipper(a), to = add_to_clipper(b);
    if (!clipper_.clip_line(from, to, codes.any)) {
        ++counts_.outside;
        return;
    }
    ++counts_.clipped;
    // A line goes to its end and back: the cuts on its way are the corners between the two.
    const std::array<ClipCorner, 2> ends{{{from}, {to}}};
    const Corners corners =
        codes.parts_depth() ? clipper_.cut_at_depths(ends, codes.any) : Corners(ends);
    batch_.reserve(corners.size(), clipper_.vertex_count() + 4);
    project_corners(corners);
    finish_corners(corners, {.provoking = b});
    for (std::size_t i = 0; corners[i].vertex != to; ++i)
        emit_line(*outline_[i], *outline_[i + 1], {.key = key_});
}

void PrimitiveStage::assembled_triangle(const std::array<std::uint32_t, 3>& slots,
                                        std::uint32_t provoking) {
    ++counts_.in;
    Codes codes;
    for (const std::uint32_t slot : slots)
        codes.add(pool_.code(slot));
    if (codes.any != 0) {
        if (codes.nothing_left()) {
            ++counts_.outside;
            return;
        }
        if ((codes.any & clip_code::CutsPolygon) != 0 || codes.parts_depth())
            return clipped_triangle(slots, provoking, codes);
    }
    const WindowVertex *a = &pool_.front(slots[0]), *b = &pool_.front(slots[1]),
                       *c = &pool_.front(slots[2]);
    const std::int64_t area = cross(*a, *b, *c);
    if (area == 0) {
        ++counts_.degenerate;
        return;
    }
    const bool front_facing = (area > 0) != registers_.front_is_clockwise;
    if (culled(front_facing)) return;
    batch_.reserve(1, 2);
    if (!plain_vertices_) {
        const Look look{provoking, front_facing};
        a = shaded(slots[0], look);
        b = shaded(slots[1], look);
        c = shaded(slots[2], look);
    }
    emit_triangle({a, b, c}, front_facing);
}

bool PrimitiveStage::culled(bool front_facing) {
    const bool drop = front_facing ? registers_.cull_front : registers_.cull_back;
    counts_.culled += drop;
    return drop;
}

void PrimitiveStage::emit_triangle(std::array<const WindowVertex*, 3> vertices, bool front_facing) {
    batch_.add({.shape = PrimitiveShape::Triangle,
                .front_facing = front_facing,
                .key = key_,
                .vertices = vertices});
}

void PrimitiveStage::clipped_triangle(const std::array<std::uint32_t, 3>& slots,
                                      std::uint32_t provoking,
                                      const Codes& codes) {
    clipper_.clear();
    std::array<ClipCorner, 3> triangle;
    for (unsigned i = 0; i < 3; ++i)
        triangle[i] = {add_to_clipper(slots[i])};
    Corners corners = clipper_.clip_polygon(triangle, codes.any, Clipper::Bounds::Polygon);
    if (corners.size() < 3) {
        ++counts_.outside;
        return;
    }
    ++counts_.clipped;
    if (codes.parts_depth()) corners = clipper_.cut_at_depths(corners, codes.any);
    batch_.reserve(corners.size(), clipper_.vertex_count() + 3);
    const std::int64_t area = project_corners(corners);
    if (area == 0) {
        ++counts_.degenerate;
        return;
    }
    const bool front_facing = (area > 0) != registers_.front_is_clockwise;
    if (culled(front_facing)) return;
    finish_corners(corners, {provoking, front_facing});
    if (!codes.parts_depth()) return emit_outline(front_facing, area > 0);
    const std::vector<const WindowVertex*> whole = outline_;
    for (const ClipCode part : {clip_code::BeforeNear, ClipCode{0}, clip_code::BeyondFar}) {
        outline_.clear();
        for (std::size_t i = 0; i < corners.size(); ++i)
            if (clipper_.is_of_part(corners[i].vertex, part)) outline_.push_back(whole[i]);
        emit_outline(front_facing, area > 0);
    }
}

// The polygon outline_ as triangles.
void PrimitiveStage::emit_outline(bool front_facing, bool counter_clockwise) {
    for (std::size_t i = 2; i < outline_.size(); ++i) {
        const std::int64_t piece = cross(*outline_[0], *outline_[i - 1], *outline_[i]);
        // A sliver that snapping turned over is none of the polygon.
        if (piece != 0 && (piece > 0) == counter_clockwise)
            emit_triangle({outline_[0], outline_[i - 1], outline_[i]}, front_facing);
    }
}

void PrimitiveStage::assembled_polygon(std::span<const PolygonCorner> polygon,
                                       std::uint32_t provoking) {
    ++counts_.in;
    reset_line_stipple();
    Codes codes;
    for (const PolygonCorner& corner : polygon)
        codes.add(pool_.code(corner.slot));
    if (codes.nothing_left()) {
        ++counts_.outside;
        return;
    }
    clipper_.clear();
    corners_.clear();
    for (const PolygonCorner& corner : polygon)
        corners_.push_back({add_to_clipper(corner.slot), corner.boundary});
    Corners corners = corners_;
    if (codes.any & (clip_code::CutsLine | clip_code::CutsPolygon)) {
        corners = clipper_.clip_polygon(corners_, codes.any, Clipper::Bounds::Exact);
        if (corners.size() < 3) {
            ++counts_.outside;
            return;
        }
        ++counts_.clipped;
    }
    batch_.reserve(2 * corners.size(), 2 * std::size_t{clipper_.vertex_count()});
    const std::int64_t area = project_corners(corners);
    // Without area neither way round is positive: back (GL 1.5, 2.14.1).
    const bool front_facing = registers_.front_is_clockwise ? area < 0 : area > 0;
    if (culled(front_facing)) return;
    const PolygonMode mode = front_facing ? registers_.front_mode : registers_.back_mode;
    if (mode == PolygonMode::Fill && !feedback_) return fill_outline(polygon, provoking);
    if (mode == PolygonMode::Line && codes.parts_depth()) {
        corners = clipper_.cut_at_depths(corners, codes.any);
        batch_.reserve(2 * corners.size(), 2 * std::size_t{clipper_.vertex_count()});
        project_corners(corners);
    }
    finish_corners(corners, {provoking, front_facing});
    if (mode == PolygonMode::Fill) return feedback_->polygon(outline_);
    draw_outline(corners, front_facing, mode);
}

// The same triangles as if both modes were Fill: multi-pass drawing may mix them.
void PrimitiveStage::fill_outline(std::span<const PolygonCorner> polygon, std::uint32_t provoking) {
    --counts_.in;
    if (polygon.size() == 4) {
        triangle({polygon[0].slot, polygon[1].slot, polygon[3].slot}, provoking);
        triangle({polygon[1].slot, polygon[2].slot, polygon[3].slot}, provoking);
        return;
    }
    for (std::size_t i = 2; i < polygon.size(); ++i)
        triangle({polygon[0].slot, polygon[i - 1].slot, polygon[i].slot}, provoking);
}

void PrimitiveStage::draw_outline(Corners corners, bool front_facing, PolygonMode mode) {
    const std::size_t size = corners.size();
    for (std::size_t i = 0; i < size; ++i) {
        if (!corners[i].boundary) continue;
        const std::size_t j = (i + 1) % size, k = (i + 2) % size;
        Primitive primitive{.front_facing = front_facing, .from_polygon = true, .key = key_};
        primitive.vertices = {outline_[i], outline_[j], outline_[k]};
        if (mode == PolygonMode::Point)
            emit_point(*outline_[i], primitive);
        else
            emit_line(*outline_[i], *outline_[j], primitive);
    }
}

} // namespace ffgpu
