// VertexFetch: walks a draw's vertices, asks the post-transform reuse and, where that has not got
// the vertex, fetches its data through the vertex cache. One vertex a cycle; misses are hidden by a
// queue.

#pragma once

#include "model/timing/channel.h"
#include "model/timing/line_cache.h"
#include "model/timing/tokens.h"
#include "model/timing/unit.h"

#include <deque>

namespace ffgpu::timing {

class VertexStatistics : public StatisticsGroup {
public:
    Counter& vertices = count("vertex_vertices", "vertices", "as indexed by draws");
    Counter& reused = count("vertex_reused", "vertices", "found in the post-transform reuse");
    Counter& shaded = count("vertex_shaded", "vertices", "transformed and lit");
};

class VertexFetch final : public Unit {
public:
    struct Ports {
        Channel<DrawToken>& draws_in;
        Channel<VertexToken>& vertices_out;
        Channel<std::uint64_t>& responses_in;
        LineCache& cache;
    };

    VertexFetch(sc_core::sc_module_name name,
                const Clock& clock,
                const VertexConfig& config,
                const Ports& ports);

    const VertexStatistics& statistics() const { return statistics_; }

private:
    struct Waiting {
        VertexToken vertex;
        std::uint64_t ticket = 0;
    };

    Activity step() override;
    bool may_sleep() const override { return true; }
    bool issue(Activity& reason);
    bool forward(Activity& reason);
    bool reuse(std::uint32_t vertex);
    void forget_rewritten(TimedScene& scene);

    const VertexConfig config_;
    const Ports ports_;
    VertexStatistics statistics_;

    bool in_draw_ = false;
    DrawToken draw_;
    std::uint32_t position_ = 0;
    std::uint64_t next_line_ = 0, end_line_ = 0; // of the vertex at position_; equal: not begun
    std::uint64_t ticket_ = 0;
    std::deque<Waiting> waiting_;
    std::deque<std::uint32_t> recent_; // the post-transform reuse, oldest first
};

} // namespace ffgpu::timing
