#include "model/timing/geometry_timing.h"

#include <algorithm>

namespace ffgpu::timing {

// A free unit takes the next vertex. A reused vertex needs none, but its place in the order.
bool GeometryTiming::begin_next() {
    const VertexConfig& config = config_.vertex;
    const std::size_t places = std::max<std::size_t>(config.order_entries, config.units);
    if (order_.size() == places || !ports_.vertices_in.can_pop()) return false;
    const VertexToken& vertex = ports_.vertices_in.front();
    Cycle done_at = now();
    if (vertex.shade) {
        const auto unit = std::min_element(free_at_.begin(), free_at_.end());
        if (*unit > now()) return false;
        const unsigned lights = vertex.draw.prepared().geometry.lights;
        const Cycle cycles = config.transform_cycles + lights * config.light_cycles;
        *unit = now() + cycles;
        done_at = *unit - 1;
        passage_.enter_unit(cycles);
    } else {
        ++passage_.entered;
    }
    order_.push_back({ports_.vertices_in.pop(), done_at});
    return true;
}

// The primitives of which this vertex is the last.
void GeometryTiming::assemble(const VertexToken& vertex) {
    assembling_ = true;
    const PreparedDraw& draw = vertex.draw.prepared();
    const auto& primitives = vertex.draw.scene->work.primitives;
    if (vertex.position == 0) end_primitive_ = 0;
    next_primitive_ = end_primitive_;
    while (end_primitive_ < draw.primitive_count &&
           primitives[draw.first_primitive + end_primitive_].last_vertex <= vertex.position)
        ++end_primitive_;
    ends_draw_ = vertex.ends_draw() && next_primitive_ == end_primitive_;
}

// The next primitive, or the vertex itself where it has none left.
bool GeometryTiming::send_next() {
    if (order_.empty() || now() < order_.front().done_at) return false;
    const VertexToken& vertex = order_.front().vertex;
    if (!assembling_) assemble(vertex);
    if (next_primitive_ != end_primitive_ || ends_draw_) {
        if (!ports_.primitives_out.can_push()) return false;
        const std::uint32_t primitive = ends_draw_ ? PrimitiveToken::None : next_primitive_++;
        ends_draw_ = false;
        const bool last = vertex.ends_draw() && next_primitive_ == end_primitive_;
        ports_.primitives_out.push({vertex.draw, primitive, last});
    }
    if (next_primitive_ != end_primitive_) return true;
    assembling_ = false;
    order_.pop_front();
    passage_.leave();
    return true;
}

// Nothing leaves before the first is done, and nothing begins before a unit is free: all cycles
// until then are busy.
void GeometryTiming::sleep_until_done() {
    const bool waits = ports_.vertices_in.can_pop();
    if (order_.empty() && !waits) rest_as(Activity::Idle);
    if (order_.empty() || assembling_) return;
    next_change_ = order_.front().done_at;
    if (waits)
        next_change_ = ports_.vertices_in.front().shade
                           ? std::min(next_change_, *std::ranges::min_element(free_at_))
                           : 0;
}

Activity GeometryTiming::step() {
    next_change_ = 0;
    bool moved = false;
    for (std::uint32_t i = 0; i < config_.vertex.vertices_per_cycle && begin_next(); ++i)
        moved = true;
    const std::uint32_t most = std::max(config_.vertex.vertices_per_cycle, config_.setup.units);
    for (std::uint32_t i = 0; i < most && send_next(); ++i)
        moved = true;
    if (moved) {
        sleep_until_done();
        return Activity::Busy;
    }
    if (order_.empty()) return Activity::Idle;
    Cycle next_change = Never;
    for (const Cycle free_at : free_at_)
        if (now() < free_at) next_change = std::min(next_change, free_at);
    if (next_change == Never) return Activity::StalledOutput;
    const Cycle first_done = order_.front().done_at;
    next_change_ = now() < first_done ? std::min(next_change, first_done) : next_change;
    return Activity::Busy;
}

} // namespace ffgpu::timing
