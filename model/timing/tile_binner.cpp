#include "model/timing/tile_binner.h"

#include <algorithm>

namespace ffgpu::timing {
namespace {

constexpr std::size_t WriteQueue = 16; // requests that the binner holds when it goes on

} // namespace

TileBinner::TileBinner(sc_core::sc_module_name name,
                       const Clock& clock,
                       const TilesConfig& config,
                       const Ports& ports,
                       InFlight& in_flight)
    : Unit(name, clock)
    , config_(config)
    , ports_(ports)
    , in_flight_(in_flight) {
    for (std::uint32_t i = 0; i < config.parameter_buffers; ++i)
        free_buffers_.push_back(i);
}

Activity TileBinner::step() {
    while (ports_.free_buffers_in.can_pop())
        free_buffers_.push_back(ports_.free_buffers_in.pop());
    const bool full = writes_.size() >= WriteQueue;
    bool sent = false;
    if (!writes_.empty() && ports_.requests_out.can_push()) {
        ports_.requests_out.push(writes_.front());
        writes_.pop_front();
        sent = true;
    }
    const Activity activity = full ? Activity::StalledRequests : work();
    return sent ? Activity::Busy : activity;
}

Activity TileBinner::work() {
    if (!has_primitive_ && !take_primitive()) return Activity::Idle;
    if (!pass_ && !begin_pass()) return Activity::StalledOutput;
    const work::TilePass& pass = pass_->token.plan();
    if (next_record_ < end_record_ && next_record_ < pass.records_end) {
        put_into_lists();
        return Activity::Busy;
    }
    const bool scene_is_over = next_record_ == end_record_ && token_.last &&
                               draws_taken_ + 1 == token_.draw.scene->work.draws.size();
    if (next_record_ < end_record_ || scene_is_over) {
        const Activity activity = end_pass();
        if (pass_ || !scene_is_over) return activity;
    }
    end_primitive();
    return Activity::Busy;
}

bool TileBinner::take_primitive() {
    if (!ports_.setups_in.can_pop()) return false;
    token_ = ports_.setups_in.pop();
    has_primitive_ = true;
    const auto& records = plan().records;
    while (end_record_ < records.size() && records[end_record_].draw == token_.draw.draw &&
           records[end_record_].piece < token_.end)
        ++end_record_;
    next_bin_ = 0;
    return true;
}

bool TileBinner::begin_pass() {
    if (free_buffers_.empty()) return false;
    if (next_pass_ == 0) {
        ++statistics_.scenes;
        in_flight_.enter(); // The scene, until its last bin is stored.
    }
    const PassToken token{token_.draw.scene, next_pass_, free_buffers_.front()};
    free_buffers_.pop_front();
    const std::size_t bins = token.plan().bins_end - token.plan().bins_begin;
    pass_.emplace(Pass{token,
                       ParameterBuffer(config_, token),
                       std::vector<std::uint32_t>(bins),
                       std::vector<std::uint32_t>(bins),
                       0});
    return true;
}

// Some entries of the record; with the first of them the record itself.
void TileBinner::put_into_lists() {
    const work::TileRecord& record = plan().records[next_record_];
    const std::uint32_t first_bin = pass_->token.plan().bins_begin;
    if (next_bin_ == 0) {
        write_record(pass_->buffer.record(next_record_));
        ++statistics_.records;
    }
    const std::uint32_t bins = record.bins_end - record.bins_begin;
    for (std::uint32_t i = 0; i < config_.entries_per_cycle && next_bin_ < bins; ++i) {
        const std::uint32_t bin = plan().record_bins[record.bins_begin + next_bin_++] - first_bin;
        ++statistics_.entries;
        if (++pass_->entries[bin] - pass_->written[bin] == config_.gathered_entries)
            write_list(bin);
    }
    if (next_bin_ < bins) return;
    ++next_record_;
    next_bin_ = 0;
}

// Writes what is left of a list and the header, a bin a cycle, then hands the pass over.
Activity TileBinner::end_pass() {
    const work::TilePass& pass = pass_->token.plan();
    const std::uint32_t bins = pass.bins_end - pass.bins_begin;
    if (pass_->next_flush < bins) {
        write_list(pass_->next_flush);
        write_record(pass_->buffer.header(pass.bins_begin + pass_->next_flush));
        ++statistics_.bins;
        ++pass_->next_flush;
        return Activity::Busy;
    }
    if (!ports_.passes_out.can_push()) return Activity::StalledOutput;
    if (record_tail_) writes_.push_back(*record_tail_);
    record_tail_.reset();
    if (!pass_->token.is_last()) ++statistics_.overflows;
    ports_.passes_out.push(pass_->token);
    next_pass_ = pass_->token.is_last() ? 0 : next_pass_ + 1;
    pass_.reset();
    return Activity::Busy;
}

void TileBinner::end_primitive() {
    has_primitive_ = false;
    if (!token_.last) return;
    TimedScene& scene = *token_.draw.scene;
    if (++draws_taken_ == scene.work.draws.size()) draws_taken_ = next_record_ = end_record_ = 0;
    in_flight_.leave(); // The draw; its scene is counted.
    scene.end_draw(token_.draw.draw, now());
}

void TileBinner::write_list(std::uint32_t bin) {
    if (pass_->written[bin] == pass_->entries[bin]) return;
    const std::uint32_t number = pass_->token.plan().bins_begin + bin;
    add_requests(
        pass_->buffer.entries(number, pass_->written[bin], pass_->entries[bin]), true, writes_);
    pass_->written[bin] = pass_->entries[bin];
}

// Records and headers follow one another: what does not end a request waits for the next.
void TileBinner::write_record(const ParameterBytes& bytes) {
    ParameterBytes all = bytes;
    if (record_tail_) all = {record_tail_->address, record_tail_->bytes + bytes.bytes};
    record_tail_.reset();
    add_requests(all, true, writes_);
    const MemoryRequest& last = writes_.back();
    if ((last.address + last.bytes) % ParameterBuffer::RequestBytes == 0) return;
    record_tail_ = last;
    writes_.pop_back();
}

} // namespace ffgpu::timing
