#include "model/timing/geometry_timing.h"

namespace ffgpu::timing {

void GeometryTiming::begin(const VertexToken& vertex) {
    vertex_ = vertex;
    const PreparedDraw& draw = vertex.draw.prepared();
    const GeometryWork& work = draw.geometry;
    const Cycle cycles =
        vertex.shade ? config_.transform_cycles + work.lights * config_.light_cycles : 1;
    shading_ = true;
    shaded_at_ = now() + std::max<Cycle>(cycles, 1) - 1;
    const std::size_t vertices = std::max<std::size_t>(work.vertices.size(), 1);
    const auto& primitives = vertex.draw.scene->work.primitives;
    if (vertex.position == 0) end_primitive_ = 0;
    next_primitive_ = end_primitive_;
    while (end_primitive_ < draw.primitive_count &&
           primitives[draw.first_primitive + end_primitive_].last_vertex <= vertex.position)
        ++end_primitive_;
    last_vertex_ = vertex.position + 1 == vertices;
    // Behind the last vertex something has to tell the draw's end.
    ends_draw_ = last_vertex_ && next_primitive_ == end_primitive_;
}

Activity GeometryTiming::step() {
    if (!shading_ && next_primitive_ == end_primitive_ && !ends_draw_) {
        if (!ports_.vertices_in.can_pop()) return Activity::Idle;
        begin(ports_.vertices_in.pop());
    }
    if (now() < shaded_at_) return Activity::Busy;
    if (next_primitive_ == end_primitive_ && !ends_draw_) {
        shading_ = false;
        return Activity::Busy;
    }
    if (!ports_.primitives_out.can_push()) return Activity::StalledOutput;
    shading_ = false;
    const bool last = last_vertex_ && (ends_draw_ || next_primitive_ + 1 == end_primitive_);
    ports_.primitives_out.push(
        {vertex_.draw, ends_draw_ ? PrimitiveToken::None : next_primitive_, last});
    if (ends_draw_) {
        ends_draw_ = false;
    } else {
        ++next_primitive_;
    }
    return Activity::Busy;
}

} // namespace ffgpu::timing
