#include "model/timing/texture_timing.h"

#include <algorithm>

namespace ffgpu::timing {

TextureTiming::TextureTiming(sc_core::sc_module_name name,
                             const Clock& clock,
                             const TexelCacheConfig& config,
                             const Ports& ports)
    : Unit(name, clock)
    , config_(config)
    , ports_(ports)
    , parked_(config.fragment_fifo) {}

bool TextureTiming::compare_tags(Activity& reason) {
    if (!comparing_) {
        if (!ports_.quads_in.can_pop()) return false;
        if (parked_.is_full()) {
            blame(reason, Activity::StalledMemory);
            return false;
        }
        current_ = ports_.quads_in.pop();
        comparing_ = true;
        next_line_ = 0;
        ticket_ = 0;
        statistics_.texel_reads += current_.quad().texel_reads;
        statistics_.samples += current_.quad().filter_steps;
        statistics_.quads += current_.quad().filter_steps > 0;
    }
    const auto lines = current_.scene->work.lines_of(current_.quad());
    for (std::uint32_t i = 0; i < config_.lookups_per_cycle && next_line_ < lines.size(); ++i) {
        const LookupResult result = ports_.cache.look_up({.number = lines[next_line_]});
        if (!result.accepted) {
            blame(reason, Activity::StalledRequests);
            return i > 0;
        }
        ++next_line_;
        ticket_ = std::max(ticket_, result.ticket);
        current_.misses += result.missed;
    }
    if (next_line_ == lines.size()) {
        parked_.park(current_, ticket_);
        comparing_ = false;
    }
    return true;
}

bool TextureTiming::filter(Activity& reason) {
    if (parked_.empty()) return false;
    if (!filtering_) {
        if (!parked_.front_has_data(ports_.cache)) {
            blame(reason, Activity::StalledMemory);
            return false;
        }
        const std::uint32_t steps = parked_.front().quad().filter_steps;
        const std::uint32_t width = config_.bilinear_quads_per_cycle;
        filter_cycles_left_ = std::max<std::uint32_t>((steps + width - 1) / width, 1);
        filtering_ = true;
    }
    if (filter_cycles_left_ > 1) {
        --filter_cycles_left_;
        return true;
    }
    if (!ports_.quads_out.can_push()) {
        blame(reason, Activity::StalledOutput);
        return false;
    }
    ports_.quads_out.push(parked_.pop());
    filtering_ = false;
    return true;
}

Activity TextureTiming::step() {
    ports_.cache.begin_cycle(ports_.responses_in);
    Activity reason = Activity::Idle;
    const bool filtered = filter(reason);
    const bool compared = compare_tags(reason);
    return filtered || compared ? Activity::Busy : reason;
}

bool TextureTiming::may_sleep() const {
    return !comparing_ && parked_.empty() && ports_.quads_in.holds_nothing() &&
           ports_.responses_in.holds_nothing() && ports_.cache.all_complete();
}

} // namespace ffgpu::timing
