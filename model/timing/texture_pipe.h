// TexturePipe: the texture units of one fragment pipe. Quads wait for them in a queue, so that a
// pipe that is behind does not hold up the others at once.

#pragma once

#include "model/base/statistics.h"
#include "model/timing/channel.h"
#include "model/timing/config.h"
#include "model/timing/parked_quads.h"

#include <deque>

namespace ffgpu::timing {

class TextureStatistics : public StatisticsGroup {
public:
    Counter& quads = count("texture_quads", "quads", "with at least one sample");
    Counter& texel_reads = count(
        "texture_texel_reads", "texels", "read by the filters, before reads of a line are merged");
    Counter& samples =
        count("texture_bilinear_samples", "quads", "bilinear or simpler samples filtered");
};

class TexturePipe {
public:
    TexturePipe(const TexelCacheConfig& config, std::size_t queue)
        : config_(config)
        , queue_(queue)
        , parked_(config.fragment_fifo) {}

    bool can_take() const { return waiting_.size() < queue_; }
    void take(const QuadToken& quad) { waiting_.push_back(quad); }
    bool holds_nothing() const { return waiting_.empty() && !comparing_ && parked_.empty(); }

    // One cycle's work of each part; false, and the reason, where there was none.
    bool compare_tags(LineCache& cache, TextureStatistics& statistics, Activity& reason);
    bool filter(const LineCache& cache, Channel<QuadToken>& out, Activity& reason);

private:
    void begin(TextureStatistics& statistics);

    const TexelCacheConfig& config_;
    std::size_t queue_;
    std::deque<QuadToken> waiting_;
    bool comparing_ = false; // current_ is between its first and its last tag
    QuadToken current_;
    std::uint32_t next_line_ = 0;
    std::uint64_t ticket_ = 0;
    ParkedQuads parked_;
    std::uint32_t filter_cycles_left_ = 0;
    bool filtering_ = false;
};

} // namespace ffgpu::timing
