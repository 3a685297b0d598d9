#include "model/timing/texture_timing.h"

#include <algorithm>
#include <utility>

namespace ffgpu::timing {
namespace {

bool has_parked(const TexturePipe& pipe) {
    return pipe.has_parked();
}

} // namespace

TextureTiming::TextureTiming(sc_core::sc_module_name name,
                             const Clock& clock,
                             const TimingConfig& config,
                             const Ports& ports)
    : Unit(name, clock)
    , config_(config)
    , ports_(ports)
    , exit_(config, ports.quads_out) {
    for (std::uint32_t i = 0; i < config.raster.quads_per_cycle; ++i)
        pipes_.emplace_back(config, ports.caches[i % ports.caches.size()]->cache);
    go_on_while_busy();
}

void TextureTiming::set_observer(QuadObserver* observer) {
    for (TexturePipe& pipe : pipes_)
        pipe.set_observer(observer);
}

bool TextureTiming::is_empty() const {
    const auto is_empty = [](const TexturePipe& pipe) {
        return !pipe.has_parked() && !pipe.has_tags_to_compare();
    };
    return exit_.is_empty() && std::all_of(pipes_.begin(), pipes_.end(), is_empty);
}

// Those before a quad whose texels may have changed read the former ones from the same caches.
inline bool TextureTiming::can_distribute() const {
    if (!ports_.quads_in.can_pop()) return false;
    const QuadToken& quad = ports_.quads_in.front();
    if (ports_.rewrites.come_before(quad.scene().number) && !is_empty()) return false;
    return pipes_[fragment_pipe(config_, quad)].can_take(quad);
}

// Nothing is under way in any of the caches.
void TextureTiming::forget_rewritten(const QuadToken& quad) {
    while (ports_.rewrites.come_before(quad.scene().number)) {
        for (const std::uint64_t line : ports_.rewrites.take()) {
            for (CachePort* const port : ports_.caches)
                port->cache.overwrite(line, LineAccess::Whole);
            if (!ports_.second_level) continue;
            const work::LineSource source =
                work::line_source(line, ports_.caches.front()->cache.line_bytes());
            ports_.second_level->invalidate(source.address, source.address + source.bytes);
        }
    }
}

void TextureTiming::forget_former_draw(const QuadToken& quad) {
    if (std::exchange(draw_, quad.draw().number) == quad.draw().number) return;
    for (CachePort* const port : ports_.caches)
        port->cache.flush();
}

// In the order in which they came: a quad whose pipe's queue is full holds up those behind it.
[[gnu::always_inline]] inline void TextureTiming::distribute() {
    const std::size_t pipes = config_.raster.quads_per_cycle;
    for (std::size_t i = 0; i < pipes && can_distribute(); ++i) {
        const QuadToken& quad = ports_.quads_in.front();
        if (ports_.rewrites.come_before(quad.scene().number)) forget_rewritten(quad);
        if (config_.texel_cache.forgets) forget_former_draw(quad);
        const std::uint32_t pipe = fragment_pipe(config_, quad);
        pipes_[pipe].take(quad);
        ports_.quads_in.drop();
        exit_.enter(pipe);
    }
}

Activity TextureTiming::step() {
    for (CachePort* port : ports_.caches)
        port->cache.begin_cycle(port->responses);
    Activity reason = Activity::Idle;
    if (ports_.quads_in.can_pop()) distribute();
    bool worked = false;
    // The pipes share the cache's ports and the way out: a different one is first whenever one
    // has worked.
    const std::size_t pipes = config_.raster.quads_per_cycle;
    for (std::size_t i = 0; i < pipes; ++i) {
        const std::size_t number = turn(first_ + i, pipes);
        TexturePipe& pipe = pipes_[number];
        if (pipe.has_parked()) worked |= pipe.filter(exit_, number, now(), reason);
        if (pipe.has_tags_to_compare()) worked |= pipe.compare_tags(statistics_, now(), reason);
    }
    worked |= exit_.advance();
    if (!worked) return reason;
    first_ = turn(first_ + 1, pipes);
    if (!ports_.quads_in.can_pop() && pipes_rest())
        rest_as(std::any_of(pipes_.begin(), pipes_.end(), has_parked) ? Activity::StalledMemory
                                                                      : Activity::Idle);
    return Activity::Busy;
}

// What is under way waits for the memory.
bool TextureTiming::pipes_rest() const {
    const auto rests = [](const TexturePipe& pipe) { return pipe.rests(); };
    const auto cache_rests = [](const CachePort* port) { return port->cache.rests(); };
    return config_.texture.rate == TexelRate::Samples && exit_.is_empty() &&
           std::all_of(pipes_.begin(), pipes_.end(), rests) &&
           std::all_of(ports_.caches.begin(), ports_.caches.end(), cache_rests);
}

bool TextureTiming::has_backlog() const {
    return Unit::has_backlog() ||
           std::any_of(pipes_.begin(), pipes_.end(), [](const TexturePipe& pipe) {
               return pipe.has_backlog();
           });
}

Cycle TextureTiming::next_work(Activity last) const {
    const bool works = last == Activity::Busy || can_distribute() || expands();
    return works ? now() + 1 : Unit::next_work(last);
}

// Texels that have come take some cycles more.
bool TextureTiming::expands() const {
    if (config_.texel_cache.decompress_cycles == 0 && config_.texture.rate == TexelRate::Samples)
        return false;
    const auto expands_texels = [](const TexturePipe& pipe) { return pipe.expands_texels(); };
    const auto expands_lines = [](const CachePort* port) { return port->cache.expands_lines(); };
    return std::any_of(pipes_.begin(), pipes_.end(), expands_texels) ||
           std::any_of(ports_.caches.begin(), ports_.caches.end(), expands_lines);
}

} // namespace ffgpu::timing
