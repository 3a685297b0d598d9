// TextureTiming: the texture units in time. Tags are compared when a quad comes in; the quad then
// waits in the fragment FIFO while its misses travel, and is filtered when it leaves: a bilinear
// sample of a quad takes a cycle, a trilinear one two.

#pragma once

#include "model/timing/channel.h"
#include "model/timing/parked_quads.h"
#include "model/timing/unit.h"

namespace ffgpu::timing {

class TextureStatistics : public StatisticsGroup {
public:
    Counter& quads = count("texture_quads", "quads", "with at least one sample");
    Counter& texel_reads = count(
        "texture_texel_reads", "texels", "read by the filters, before reads of a line are merged");
    Counter& samples =
        count("texture_bilinear_samples", "quads", "bilinear or simpler samples filtered");
};

class TextureTiming final : public Unit {
public:
    struct Ports {
        Channel<QuadToken>& quads_in;
        Channel<QuadToken>& quads_out;
        Channel<std::uint64_t>& responses_in;
        LineCache& cache;
    };

    TextureTiming(sc_core::sc_module_name name,
                  const Clock& clock,
                  const TexelCacheConfig& config,
                  const Ports& ports);

    const TextureStatistics& statistics() const { return statistics_; }

private:
    Activity step() override;
    bool may_sleep() const override;
    bool compare_tags(Activity& reason);
    bool filter(Activity& reason);

    const TexelCacheConfig config_;
    const Ports ports_;
    TextureStatistics statistics_;

    bool comparing_ = false; // current_ is between its first and its last tag
    QuadToken current_;
    std::uint32_t next_line_ = 0;
    std::uint64_t ticket_ = 0;
    ParkedQuads parked_;
    std::uint32_t filter_cycles_left_ = 0;
    bool filtering_ = false;
};

} // namespace ffgpu::timing
