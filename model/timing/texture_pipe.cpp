#include "model/timing/texture_pipe.h"

#include <algorithm>

namespace ffgpu::timing {

bool TexturePipe::begin(TextureStatistics& statistics, Activity& reason) {
    if (waiting_.empty()) return false; // Only a miss took its cycles.
    if (parked_.size() >= config_.texel_cache.fragment_fifo) {
        blame(reason, Activity::StalledMemory);
        return false;
    }
    current_ = waiting_.front();
    waiting_.pop_front();
    to_tags_.leave();
    comparing_ = true;
    ticket_ = 0;
    const PreparedQuad& quad = current_.quad();
    share_.begin(current_.part->work, quad);
    count(statistics, quad);
    return true;
}

void TexturePipe::count(TextureStatistics& statistics, const PreparedQuad& quad) {
    statistics.texel_reads += quad.texel_reads;
    statistics.samples += quad.filter_steps;
    statistics.quads += quad.filter_steps > 0;
}

bool TexturePipe::stream_tags(TextureStatistics& statistics, Cycle now, Activity& reason) {
    requests_.advance();
    if (!stream_.is_comparing()) {
        if (waiting_.empty()) return false;
        stream_.begin(waiting_.front());
        waiting_.pop_front();
        to_tags_.leave();
        count(statistics, stream_.current().quad());
    }
    const bool worked = stream_.compare(requests_, reason, [&](std::uint64_t line) {
        const LookupResult result = cache_.look_up({.number = line});
        if (observer_ && result.accepted)
            observer_->texel_line(name_of(stream_.current()), {line, result.missed, now});
        return result;
    });
    // A cycle without a sample, too: the sequencer is at work.
    to_tags_.worked += worked || stream_.lacks_sample(requests_);
    to_filter_.entered = stream_.tagged();
    to_exit_.entered = stream_.read_quads();
    return worked;
}

bool TexturePipe::stream_data(PipeExit& out, std::size_t pipe, Cycle now, Activity& reason) {
    const bool read = stream_.read_texel(now, reason);
    if (read) {
        to_filter_.leave(stream_.ticket_read());
        ++to_filter_.worked;
    }
    to_exit_.entered = stream_.read_quads();
    if (!stream_.can_leave(now)) return read;
    if (!out.can_push(pipe)) {
        blame(reason, Activity::StalledOutput);
        return read;
    }
    out.push(pipe, stream_.front());
    stream_.pop();
    to_exit_.leave();
    inside_.leave();
    return true;
}

bool TexturePipe::compare_tags(TextureStatistics& statistics, Cycle now, Activity& reason) {
    if (config_.texture.rate == TexelRate::Texels) return stream_tags(statistics, now, reason);
    const bool worked = compare(statistics, now, reason);
    to_tags_.worked += worked || lacks_port_;
    return worked;
}

bool TexturePipe::compare(TextureStatistics& statistics, Cycle now, Activity& reason) {
    lacks_port_ = false;
    if (miss_cycles_left_ > 0 && --miss_cycles_left_ > 0) return true;
    if (!comparing_ && !begin(statistics, reason)) return false;
    const auto lines = current_.part->work.lines_of(current_.quad());
    share_.begin_cycle();
    for (bool worked = false; !share_.is_done() && share_.has_turn(); worked = true) {
        const std::uint64_t line = lines[share_.line()];
        const LookupResult result = cache_.look_up({.number = line});
        lacks_port_ = result.lacks_port;
        if (!result.accepted) {
            blame(reason, Activity::StalledRequests);
            return worked;
        }
        if (observer_) observer_->texel_line(name_of(current_), {line, result.missed, now});
        share_.advance();
        ticket_ = std::max(ticket_, result.ticket);
        current_.misses += result.missed;
        if (result.missed && config_.texture.miss_cycles > 0) {
            miss_cycles_left_ = config_.texture.miss_cycles; // The quad goes on in the last.
            return true;
        }
    }
    if (share_.is_done()) {
        parked_.push_back({current_, ticket_});
        ++to_filter_.entered;
        comparing_ = false;
    }
    return true;
}

// A quad a cycle, in order.
void TexturePipe::read_texels(Cycle now) {
    if (read_ == parked_.size() || !cache_.is_complete(parked_[read_].ticket)) return;
    Parked& quad = parked_[read_++];
    const bool expands = quad.quad.quad().expands_blocks;
    quad.ready_at = now + (expands ? config_.texel_cache.decompress_cycles : 0);
}

bool TexturePipe::filter(PipeExit& out, std::size_t pipe, Cycle now, Activity& reason) {
    if (config_.texture.rate == TexelRate::Texels) return stream_data(out, pipe, now, reason);
    read_texels(now);
    if (!filtering_) {
        if (read_ == 0 || parked_.front().ready_at > now) {
            blame(reason, Activity::StalledMemory);
            return false;
        }
        const QuadToken& quad = parked_.front().quad;
        filter_cycles_left_ = share_.filter_cycles(quad.part->work, quad.quad());
        filtering_ = true;
    }
    if (filter_cycles_left_ > 1) {
        --filter_cycles_left_;
        ++to_filter_.worked;
        return true;
    }
    if (!out.can_push(pipe)) {
        blame(reason, Activity::StalledOutput);
        return false;
    }
    out.push(pipe, parked_.front().quad);
    to_filter_.leave(parked_.front().ticket);
    ++to_filter_.worked;
    parked_.pop_front();
    --read_;
    filtering_ = false;
    return true;
}

} // namespace ffgpu::timing
