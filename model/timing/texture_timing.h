// TextureTiming: the texture units in time, of all fragment pipes, and their texel caches. Tags are
// compared when a quad comes in; the quad then waits in its pipe's fragment FIFO while its misses
// travel, and is filtered when it leaves: a bilinear sample of a quad takes a cycle, a trilinear
// one two.

#pragma once

#include "model/timing/cache_port.h"
#include "model/timing/texel_rewrites.h"
#include "model/timing/texture_pipe.h"
#include "model/timing/unit.h"

#include <vector>

namespace ffgpu::timing {

class TextureTiming final : public Unit {
public:
    struct Ports {
        Channel<QuadToken>& quads_in;
        Channel<QuadToken>& quads_out;
        std::vector<CachePort*> caches; // one, or one for each pipe
        LineCache* second_level;        // behind them; null: none
        TexelRewrites& rewrites;
    };

    TextureTiming(sc_core::sc_module_name name,
                  const Clock& clock,
                  const TimingConfig& config,
                  const Ports& ports);

    std::string state() const override;
    const TextureStatistics& statistics() const { return statistics_; }
    void set_observer(QuadObserver* observer);
    const std::vector<TexturePipe>& pipes() const { return pipes_; }
    const PipeExit& exit() const { return exit_; }

private:
    Activity step() override;
    Cycle next_work(Activity last) const override;
    bool expands() const;
    bool has_backlog() const override;
    bool can_distribute() const;
    void distribute();
    bool is_empty() const;
    bool pipes_rest() const;
    void forget_rewritten(const QuadToken& quad);
    void forget_former_draw(const QuadToken& quad);

    const TimingConfig& config_;
    const Ports ports_;
    TextureStatistics statistics_;
    PipeExit exit_;
    std::vector<TexturePipe> pipes_;
    std::uint32_t draw_ = ~0u; // of the quad that came last
    std::size_t first_ = 0;    // pipe at the cache and the way out
};

} // namespace ffgpu::timing
