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

// As the post-transform caches of the time. A vertex is new in every draw.
bool VertexFetch::reuse(std::uint32_t vertex) {
    const auto found = std::find(recent_.begin(), recent_.end(), vertex);
    const bool is_there = found != recent_.end();
    if (is_there && config_.reuse_policy == ReusePolicy::Fifo) return true;
    if (is_there) recent_.erase(found);
    if (config_.reuse_entries == 0) return false;
    if (recent_.size() == config_.reuse_entries) recent_.pop_front();
    recent_.push_back(vertex);
    return is_there;
}

// What the host wrote before these draws is not what the caches hold. Vertices are never dirty.
void VertexFetch::forget_rewritten(TimedScene& scene) {
    for (const HostWrite& write : scene.host_writes)
        for (LineCache* const cache : {&ports_.cache, &ports_.index_cache})
            check(cache->invalidate(write.begin, write.end).empty(), "the caches only read");
    scene.host_writes.clear();
}

// A draw whose memory was rewritten waits for the vertices before it, which are read from the same
// caches.
bool VertexFetch::begin_draw() {
    if (!ports_.draws_in.can_pop()) return false;
    if (!ports_.draws_in.front().scene->host_writes.empty() && !named_.empty()) return false;
    draw_ = ports_.draws_in.pop();
    forget_rewritten(*draw_.scene);
    in_draw_ = true;
    position_ = 0;
    has_index_line_ = false;
    return true;
}

bool VertexFetch::ask_index(Activity& reason) {
    if (named_.size() == config_.index_queue) return false;
    if (!in_draw_ && !begin_draw()) return false;
    const GeometryWork& work = draw_.prepared().geometry;
    if (work.index_bytes != 0 && !work.vertices.empty()) {
        const std::uint64_t at = work.index_address + std::uint64_t{position_} * work.index_bytes;
        const std::uint64_t line = quotient(at, config_.line_bytes); // An index lies in one line.
        if (!has_index_line_ || line != index_line_) {
            const LookupResult result = indices().look_up({.number = line});
            if (!result.accepted) {
                reason = Activity::StalledRequests;
                return false;
            }
            has_index_line_ = true;
            index_line_ = line;
            index_ticket_ = result.ticket;
        }
    }
    named_.push_back({{draw_, position_, false}, has_index_line_ ? index_ticket_ : 0, 0});
    if (named_.back().vertex.ends_draw()) in_draw_ = false;
    ++position_;
    ++to_vertices_.entered;
    return true;
}

bool VertexFetch::ask_vertex(Activity& reason) {
    if (named_.empty()) return false;
    Waiting& next = named_.front();
    if (waiting_.size() == config_.fetch_queue || !indices().is_complete(next.ticket)) {
        reason = Activity::StalledMemory;
        return false;
    }
    VertexToken& vertex = next.vertex;
    const GeometryWork& work = vertex.draw.prepared().geometry;
    if (next_line_ == end_line_) {
        ticket_ = 0;
        if (vertex.position == 0) recent_.clear();
        if (!work.vertices.empty()) { // An image has none: it passes as one token.
            const std::uint32_t number = work.vertices[vertex.position];
            ++statistics_.vertices;
            vertex.shade = !reuse(number);
            ++(vertex.shade ? statistics_.shaded : statistics_.reused);
            const std::uint64_t at =
                work.vertex_address + std::uint64_t{number} * work.vertex_bytes;
            next_line_ = quotient(at, config_.line_bytes);
            end_line_ =
                vertex.shade
                    ? quotient(at + std::max(work.vertex_bytes, 1u) - 1, config_.line_bytes) + 1
                    : next_line_;
        }
    }
    if (next_line_ != end_line_) {
        const LookupResult result = ports_.cache.look_up({.number = next_line_});
        lacks_port_ = result.lacks_port;
        if (!result.accepted) {
            reason = Activity::StalledRequests;
            return false;
        }
        ticket_ = std::max(ticket_, result.ticket);
        ++to_geometry_.looked_up;
        if (++next_line_ != end_line_) return true;
    }
    waiting_.push_back({vertex, ticket_, vertex.shade ? work.vertex_bytes : 0});
    ++to_geometry_.entered;
    to_vertices_.leave(next.ticket);
    named_.pop_front();
    return true;
}

// The first vertex, or a part of it. `bytes`: that may still be sent in this cycle; `left`:
// vertices that have left in it. Behind the last of these the bytes go ahead of their vertex.
bool VertexFetch::forward(std::uint32_t& bytes, std::uint32_t& left, Activity& reason) {
    if (waiting_.empty()) return false;
    Waiting& first = waiting_.front();
    if (!ports_.cache.is_complete(first.ticket)) {
        reason = Activity::StalledMemory;
        return false;
    }
    const bool may_leave = left < config_.vertices_per_cycle;
    if (may_leave && !ports_.vertices_out.can_push()) {
        reason = Activity::StalledOutput;
        return false;
    }
    const std::uint32_t sent = std::min(bytes, first.bytes_left);
    statistics_.fetched_bytes += sent;
    bytes -= sent;
    first.bytes_left -= sent;
    if (first.bytes_left > 0 || !may_leave) return sent > 0;
    ++left;
    ports_.vertices_out.push(first.vertex);
    to_geometry_.leave(first.ticket);
    waiting_.pop_front();
    return true;
}

Activity VertexFetch::step() {
    ports_.cache.begin_cycle(ports_.responses_in);
    ports_.index_cache.begin_cycle(ports_.index_responses_in);
    Activity reason = Activity::Idle, ask_reason = Activity::Idle;
    const std::uint32_t most =
        config_.fetch_bytes_per_cycle == 0 ? ~0u : config_.fetch_bytes_per_cycle;
    std::uint32_t bytes = most;
    bool moved = false;
    for (std::uint32_t left = 0; forward(bytes, left, reason);)
        moved = true;
    to_geometry_.worked += bytes < most;
    std::uint32_t asked = 0;
    lacks_port_ = false;
    for (; asked < config_.vertices_per_cycle && ask_vertex(ask_reason); ++asked)
        moved = true;
    // Of a bank without a port the rest of the cycle is work.
    if (lacks_port_) to_geometry_.looked_up += config_.vertices_per_cycle - asked;
    for (std::uint32_t i = 0; i < config_.vertices_per_cycle && ask_index(ask_reason); ++i)
        moved = true;
    if (moved) return Activity::Busy;
    return reason != Activity::Idle ? reason : ask_reason;
}

} // namespace ffgpu::timing
