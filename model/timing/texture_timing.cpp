#include "model/timing/texture_timing.h"

#include "model/timing/fragment_pipes.h"

#include <algorithm>

namespace ffgpu::timing {

TextureTiming::TextureTiming(sc_core::sc_module_name name,
                             const Clock& clock,
                             const TimingConfig& config,
                             const Ports& ports)
    : Unit(name, clock)
    , config_(config)
    , ports_(ports)
    , pipes_(config.raster.quads_per_cycle,
             TexturePipe(config.texel_cache, config.fragment.pipe_queue)) {}

bool TextureTiming::can_distribute() const {
    return ports_.quads_in.can_pop() &&
           pipes_[fragment_pipe(config_, ports_.quads_in.front().quad())].can_take();
}

// In the order in which they came: a quad whose pipe's queue is full holds up those behind it.
void TextureTiming::distribute() {
    for (std::size_t i = 0; i < pipes_.size() && can_distribute(); ++i) {
        TexturePipe& pipe = pipes_[fragment_pipe(config_, ports_.quads_in.front().quad())];
        pipe.take(ports_.quads_in.pop());
    }
}

Activity TextureTiming::step() {
    ports_.cache.begin_cycle(ports_.responses_in);
    Activity reason = Activity::Idle;
    distribute();
    bool worked = false;
    // The pipes share the cache's ports and the way out: a different one is first whenever one
    // has worked.
    for (std::size_t i = 0; i < pipes_.size(); ++i) {
        TexturePipe& pipe = pipes_[(first_ + i) % pipes_.size()];
        worked |= pipe.filter(ports_.cache, ports_.quads_out, reason);
        worked |= pipe.compare_tags(ports_.cache, statistics_, reason);
    }
    if (!worked) return reason;
    first_ = (first_ + 1) % pipes_.size();
    return Activity::Busy;
}

} // namespace ffgpu::timing
