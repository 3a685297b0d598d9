#include "model/timing/parameter_fetch.h"

namespace ffgpu::timing {

bool ParameterFetch::open_bin() {
    if (open_.size() == config_.fetch_ahead) return false;
    if (!pass_) {
        if (!ports_.passes_in.can_pop()) return false;
        pass_ = ports_.passes_in.pop();
        next_bin_ = pass_->plan().bins_begin;
    }
    const work::TilePass& pass = pass_->plan();
    Open& open = open_.emplace_back();
    open.ticket = next_ticket_++;
    open.token = {.pass = *pass_, .bin = next_bin_, .empty = next_bin_ == pass.bins_end};
    if (!open.token.empty) {
        const ParameterBuffer buffer(config_, *pass_);
        const work::TileBin& bin = open.token.plan();
        const std::uint32_t entries = bin.list_end - bin.list_begin;
        add_requests(buffer.header(next_bin_), false, open.requests);
        add_requests(buffer.entries(next_bin_, 0, entries), false, open.requests);
        for (std::uint32_t i = bin.list_begin; i < bin.list_end; ++i)
            add_requests(buffer.record(pass_->scene->work.tiles.lists[i]), false, open.requests);
        open.set_up_cycles = std::uint64_t{entries} * config_.entry_cycles;
        ++next_bin_;
    }
    open.token.last_of_pass = next_bin_ == pass.bins_end;
    if (open.token.last_of_pass) pass_.reset();
    return true;
}

// A request a cycle, of the oldest bin that has one.
Activity ParameterFetch::request() {
    for (Open& open : open_) {
        if (open.requests.empty()) continue;
        if (!ports_.requests_out.can_push()) return Activity::StalledRequests;
        MemoryRequest request = open.requests.front();
        request.ticket = open.ticket;
        ports_.requests_out.push(request);
        open.requests.pop_front();
        ++open.on_their_way;
        return Activity::Busy;
    }
    return Activity::Idle;
}

Activity ParameterFetch::set_up() {
    if (open_.empty()) return Activity::Idle;
    Open& first = open_.front();
    if (!first.requests.empty() || first.on_their_way > 0) return Activity::StalledMemory;
    if (first.set_up_cycles > 0) {
        --first.set_up_cycles;
        return Activity::Busy;
    }
    if (!ports_.bins_out.can_push()) return Activity::StalledOutput;
    ports_.bins_out.push(first.token);
    open_.pop_front();
    return Activity::Busy;
}

Activity ParameterFetch::step() {
    while (ports_.responses_in.can_pop())
        --open_[ports_.responses_in.pop() - open_.front().ticket].on_their_way;
    const bool opened = open_bin();
    const Activity set = set_up(), asked = request();
    if (opened || set == Activity::Busy || asked == Activity::Busy) return Activity::Busy;
    return asked == Activity::StalledRequests ? asked : set;
}

} // namespace ffgpu::timing
