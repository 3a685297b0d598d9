#include "model/timing/vertex_fetch.h"

#include <algorithm>

namespace ffgpu::timing {

VertexFetch::VertexFetch(sc_core::sc_module_name name,
                         const Clock& clock,
                         const VertexConfig& config,
                         const Ports& ports)
    : Unit(name, clock)
    , config_(config)
    , ports_(ports) {}

// First in, first out, as the post-transform caches of the time. A vertex is new in every draw.
bool VertexFetch::reuse(std::uint32_t vertex) {
    if (std::find(recent_.begin(), recent_.end(), vertex) != recent_.end()) return true;
    if (config_.reuse_entries == 0) return false;
    if (recent_.size() == config_.reuse_entries) recent_.pop_front();
    recent_.push_back(vertex);
    return false;
}

// What the host wrote before these draws is not what the cache holds. Vertices are never dirty.
void VertexFetch::forget_rewritten(TimedScene& scene) {
    for (const HostWrite& write : scene.host_writes)
        check(ports_.cache.invalidate(write.begin, write.end).empty(), "the cache only reads");
    scene.host_writes.clear();
}

bool VertexFetch::issue(Activity& reason) {
    if (!in_draw_) {
        if (!ports_.draws_in.can_pop()) return false;
        draw_ = ports_.draws_in.pop();
        forget_rewritten(*draw_.scene);
        in_draw_ = true;
        position_ = 0;
        recent_.clear();
    }
    if (waiting_.size() == config_.fetch_queue) {
        reason = Activity::StalledMemory;
        return false;
    }
    const GeometryWork& work = draw_.prepared().geometry;
    if (work.vertices.empty()) { // An image: passes as one token.
        waiting_.push_back({{draw_, 0, false}, 0});
        in_draw_ = false;
        return true;
    }
    const std::uint32_t vertex = work.vertices[position_];
    bool shade = true;
    if (next_line_ == end_line_) {
        ++statistics_.vertices;
        ticket_ = 0;
        if (reuse(vertex)) {
            shade = false;
            ++statistics_.reused;
        } else {
            ++statistics_.shaded;
            const std::uint64_t address =
                work.vertex_address + std::uint64_t{vertex} * work.vertex_bytes;
            next_line_ = address / config_.line_bytes;
            end_line_ = (address + std::max(work.vertex_bytes, 1u) - 1) / config_.line_bytes + 1;
        }
    }
    if (shade) {
        const LookupResult result = ports_.cache.look_up({.number = next_line_});
        if (!result.accepted) {
            reason = Activity::StalledRequests;
            return false;
        }
        ticket_ = std::max(ticket_, result.ticket);
        if (++next_line_ != end_line_) return true;
    }
    waiting_.push_back({{draw_, position_, shade}, ticket_});
    if (++position_ == work.vertices.size()) in_draw_ = false;
    return true;
}

bool VertexFetch::forward(Activity& reason) {
    if (waiting_.empty()) return false;
    if (!ports_.cache.is_complete(waiting_.front().ticket)) {
        reason = Activity::StalledMemory;
        return false;
    }
    if (!ports_.vertices_out.can_push()) {
        reason = Activity::StalledOutput;
        return false;
    }
    ports_.vertices_out.push(waiting_.front().vertex);
    waiting_.pop_front();
    return true;
}

Activity VertexFetch::step() {
    ports_.cache.begin_cycle(ports_.responses_in);
    Activity reason = Activity::Idle;
    const bool forwarded = forward(reason);
    Activity issue_reason = reason;
    const bool issued = issue(issue_reason);
    if (forwarded || issued) return Activity::Busy;
    return reason != Activity::Idle ? reason : issue_reason;
}

} // namespace ffgpu::timing
