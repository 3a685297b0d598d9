#include "model/timing/texture_pipe.h"

#include <algorithm>

namespace ffgpu::timing {

void TexturePipe::begin(TextureStatistics& statistics) {
    current_ = waiting_.front();
    waiting_.pop_front();
    comparing_ = true;
    next_line_ = 0;
    ticket_ = 0;
    statistics.texel_reads += current_.quad().texel_reads;
    statistics.samples += current_.quad().filter_steps;
    statistics.quads += current_.quad().filter_steps > 0;
}

bool TexturePipe::compare_tags(LineCache& cache, TextureStatistics& statistics, Activity& reason) {
    if (!comparing_) {
        if (waiting_.empty()) return false;
        if (parked_.is_full()) {
            blame(reason, Activity::StalledMemory);
            return false;
        }
        begin(statistics);
    }
    const auto lines = current_.scene->work.lines_of(current_.quad());
    for (std::uint32_t i = 0; i < config_.lookups_per_cycle && next_line_ < lines.size(); ++i) {
        const LookupResult result = cache.look_up({.number = lines[next_line_]});
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

bool TexturePipe::filter(const LineCache& cache, Channel<QuadToken>& out, Activity& reason) {
    if (parked_.empty()) return false;
    if (!filtering_) {
        if (!parked_.front_has_data(cache)) {
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
    if (!out.can_push()) {
        blame(reason, Activity::StalledOutput);
        return false;
    }
    out.push(parked_.pop());
    filtering_ = false;
    return true;
}

} // namespace ffgpu::timing
