// The second half of PrimitiveStage: vertices get their colours, cuts their attributes, and points
// and lines are handed over.

#include "model/arith/range.h"
#include "model/geometry/primitive_stage.h"
#include "model/packets/line_columns.h"

#include <algorithm>
#include <cstring>

namespace ffgpu {
namespace {

std::int64_t cross(const WindowVertex& a, const WindowVertex& b) {
    return std::int64_t{a.x} * b.y - std::int64_t{b.x} * a.y;
}

} // namespace

void PrimitiveStage::emit_point(const WindowVertex& vertex, const Primitive& like) {
    if (feedback_) return feedback_->point(vertex);
    Primitive primitive = like;
    primitive.shape = PrimitiveShape::Point;
    primitive.vertices[0] = &vertex;
    batch_.add(primitive);
}

void PrimitiveStage::emit_line(const WindowVertex& a,
                               const WindowVertex& b,
                               const Primitive& like) {
    const bool was_reset = stipple_was_reset_;
    stipple_was_reset_ = false;
    if (feedback_) return feedback_->line(a, b, was_reset);
    if (a.x == b.x && a.y == b.y) {
        ++counts_.degenerate;
        return;
    }
    Primitive primitive = like;
    primitive.shape = PrimitiveShape::Line;
    primitive.stipple_counter = static_cast<std::uint16_t>(stipple_counter_);
    primitive.vertices[0] = &a;
    primitive.vertices[1] = &b;
    batch_.add(primitive);
    if (!counts_stipple_) return;

    // The pattern repeats after 16 * factor; the counter stays within.
    MajorLine line = major_line(a, b);
    unsigned count = 0;
    if (registers_.line_smooth) {
        count = static_cast<unsigned>(
            std::abs(perturbed_pixel(line.to_u) - perturbed_pixel(line.from_u)));
    } else {
        const std::int32_t shift =
            (line_pixels_across(registers_.line_width) - 1) * (1 << (SubPixelBits - 1));
        line.from_v -= shift;
        line.to_v -= shift;
        count = static_cast<unsigned>(line_columns(line).count);
    }
    const unsigned period = 16u * std::max<unsigned>(registers_.line_stipple_factor, 1);
    stipple_counter_ = (stipple_counter_ + count) % period;
}

const WindowVertex* PrimitiveStage::shaded(std::uint32_t slot, Look look) {
    const WindowVertex& vertex = pool_.side(slot, look.front_facing);
    if (!registers_.flat_shading || slot == look.provoking) return &vertex;
    return with_colors_of(vertex, pool_.side(look.provoking, look.front_facing));
}

// A copy only where the colours differ: whole faces of one colour are common.
const WindowVertex* PrimitiveStage::with_colors_of(const WindowVertex& vertex,
                                                   const WindowVertex& provoking) {
    const auto same = [&](int offset, std::size_t count) {
        return offset < 0 || std::memcmp(&vertex.attributes[static_cast<unsigned>(offset)],
                                         &provoking.attributes[static_cast<unsigned>(offset)],
                                         count * sizeof(float)) == 0;
    };
    if (same(layout_.color, 4) && same(layout_.secondary, 3)) return &vertex;

    WindowVertex& copy = batch_.new_vertex();
    copy_vertex(vertex, copy, layout_.count);
    const auto take = [&](int offset, unsigned count) {
        if (offset >= 0)
            std::copy_n(&provoking.attributes[static_cast<unsigned>(offset)],
                        count,
                        &copy.attributes[static_cast<unsigned>(offset)]);
    };
    take(layout_.color, 4);
    take(layout_.secondary, 3);
    return &copy;
}

// Makes window vertices of all cuts and gives those of `corners` their coordinates; returns twice
// the polygon's signed area.
std::int64_t PrimitiveStage::project_corners(Corners corners) {
    const std::uint32_t count = clipper_.vertex_count();
    cuts_.assign(count, nullptr);
    for (std::uint32_t i = 0; i < count; ++i)
        if (clipper_.vertex(i).made) cuts_[i] = &batch_.new_vertex();

    const auto place = [&](const ClipCorner& corner) -> const WindowVertex& {
        WindowVertex* const cut = cuts_[corner.vertex];
        if (!cut) return pool_.front(clipper_.vertex(corner.vertex).slot);
        clipper_.project(corner.vertex, *cut);
        return *cut;
    };
    if (corners.empty()) return 0;
    std::int64_t area = 0;
    const WindowVertex* previous = &place(corners.back());
    for (const ClipCorner& corner : corners) {
        const WindowVertex* const here = &place(corner);
        area += cross(*previous, *here);
        previous = here;
    }
    return area;
}

// Gives all vertices of the clipper their final attributes and lists the corners' in outline_.
void PrimitiveStage::finish_corners(Corners corners, Look look) {
    shade_cuts(look);
    outline_.clear();
    for (const ClipCorner& corner : corners)
        outline_.push_back(shaded_[corner.vertex]);
}

void PrimitiveStage::shade_cuts(Look look) {
    const std::uint32_t count = clipper_.vertex_count();
    shaded_.assign(count, nullptr);
    for (std::uint32_t i = 0; i < count; ++i) {
        const ClipVertex& vertex = clipper_.vertex(i);
        if (vertex.made) interpolate(vertex, *cuts_[i]);
        shaded_[i] = vertex.made ? cuts_[i] : shaded(vertex.slot, look);
    }
}

// In binary64, rounded once and put in range: attributes are linear in clip space.
void PrimitiveStage::interpolate(const ClipVertex& cut, WindowVertex& result) const {
    const WindowVertex& a = *shaded_[cut.from];
    const WindowVertex& b = *shaded_[cut.to];
    const auto between = [&](float from, float to) {
        return in_range(static_cast<float>(double{from} + cut.t * (double{to} - double{from})));
    };
    result.point_size = between(a.point_size, b.point_size);
    for (unsigned i = 0; i < layout_.count; ++i)
        result.attributes[i] = between(a.attributes[i], b.attributes[i]);
}

} // namespace ffgpu
