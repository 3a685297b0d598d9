// VertexFetch: walks a draw's vertices in three steps, each ahead of the next: it asks for the
// lines of the indices; asks the post-transform reuse for the vertex, and where that has not got
// it, the vertex cache for its lines; and sends it on when its data are there. Queues between the
// steps hide the misses.

#pragma once

#include "model/base/ring.h"
#include "model/timing/channel.h"
#include "model/timing/line_cache.h"
#include "model/timing/passage.h"
#include "model/timing/tokens.h"
#include "model/timing/unit.h"

#include <deque>

namespace ffgpu::timing {

class VertexStatistics : public StatisticsGroup {
public:
    Counter& vertices = count("vertex_vertices", "vertices", "as indexed by draws");
    Counter& reused = count("vertex_reused", "vertices", "found in the post-transform reuse");
    Counter& shaded = count("vertex_shaded", "vertices", "transformed and lit");
    Counter& fetched_bytes =
        count("vertex_fetched_bytes", "bytes", "of attributes, sent to the geometry units");
};

class VertexFetch final : public Unit {
public:
    struct Ports {
        Channel<DrawToken>& draws_in;
        Channel<VertexToken>& vertices_out;
        Channel<std::uint64_t>& responses_in;
        LineCache& cache;
        Channel<std::uint64_t>& index_responses_in;
        LineCache& index_cache;
    };

    VertexFetch(sc_core::sc_module_name name,
                const Clock& clock,
                const VertexConfig& config,
                const Ports& ports);

    std::string state() const override;
    const VertexStatistics& statistics() const { return statistics_; }
    // Through the queue of indices that were asked for, and that of vertices.
    const Passage& to_vertices() const { return to_vertices_; }
    const Passage& to_geometry() const { return to_geometry_; }

private:
    struct Waiting {
        VertexToken vertex;
        std::uint64_t ticket = 0;
        std::uint32_t bytes_left = 0; // of its attributes, on their way to the geometry units
    };

    Activity step() override;
    bool has_backlog() const override { return in_draw_ || !named_.empty() || Unit::has_backlog(); }
    bool ask_index(Activity& reason);
    bool begin_draw();
    bool ask_vertex(Activity& reason);
    bool forward(std::uint32_t& bytes, std::uint32_t& left, Activity& reason);
    bool reuse(std::uint32_t vertex);
    void forget_rewritten(TimedScene& scene);
    LineCache& indices() const {
        return config_.index_cache_lines > 0 ? ports_.index_cache : ports_.cache;
    }

    const VertexConfig config_;
    const Ports ports_;
    VertexStatistics statistics_;

    // The indices.
    bool in_draw_ = false;
    DrawToken draw_;
    std::uint32_t position_ = 0;
    std::uint64_t index_line_ = 0, index_ticket_ = 0; // of the line that was asked for last
    bool has_index_line_ = false;                     // in this draw
    Ring<Waiting> named_;                             // vertices whose index was asked for
    Passage to_vertices_;

    // The vertices.
    std::uint64_t next_line_ = 0, end_line_ = 0; // of named_'s first; equal: not begun
    std::uint64_t ticket_ = 0;
    bool lacks_port_ = false; // the bank of next_line_, in this cycle
    Ring<Waiting> waiting_;
    Passage to_geometry_;
    std::deque<std::uint32_t> recent_; // the post-transform reuse, the next to go first
};

} // namespace ffgpu::timing
