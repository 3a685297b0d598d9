#include "model/timing/tile_memory.h"

#include "model/timing/parked_quads.h"

#include <algorithm>

namespace ffgpu::timing {

TileMemory::TileMemory(sc_core::sc_module_name name,
                       const Clock& clock,
                       const TilesConfig& config,
                       std::uint32_t bin_size,
                       const Ports& ports,
                       InFlight& in_flight)
    : Unit(name, clock)
    , config_(config)
    , clear_cycles_((std::uint64_t{bin_size} * bin_size + config.clear_pixels_per_cycle - 1) /
                    config.clear_pixels_per_cycle)
    , ports_(ports)
    , in_flight_(in_flight) {}

bool TileMemory::open_bin() {
    if (open_.size() == config_.buffers || !ports_.bins_in.can_pop()) return false;
    Open& open = open_.emplace_back();
    open.token = ports_.bins_in.pop();
    open.ticket = next_ticket_++;
    if (open.token.pass.pass == 0 && open.token.bin == 0)
        statistics_.needless_stores += open.token.pass.scene->work.tiles.needless_stores;
    if (open.token.empty) return true;
    open.token.pass.scene->set_bin_waiter(*this);
    const work::TileBin& bin = open.token.plan();
    open.next_line = bin.loads_begin;
    open.clear_cycles = bin.clears * clear_cycles_;
    statistics_.clears += bin.clears;
    return true;
}

// Stores before loads, since they free a place.
Activity TileMemory::move_line() {
    for (const State state : {State::Storing, State::Loading}) {
        for (Open& open : open_) {
            if (open.state != state || open.token.empty) continue;
            const work::TileBin& bin = open.token.plan();
            const bool write = state == State::Storing;
            if (open.next_line == (write ? bin.stores_end : bin.loads_end)) continue;
            if (!ports_.requests_out.can_push()) return Activity::StalledRequests;
            const work::PlacedLine& line = open.token.pass.scene->work.tiles.lines[open.next_line];
            ports_.requests_out.push({.address = line.address,
                                      .bytes = line.bytes,
                                      .write = write,
                                      .client = line.depth ? Client::Depth : Client::Color,
                                      .ticket = open.ticket});
            ++open.next_line;
            open.on_their_way += !write;
            count(line, write);
            return Activity::Busy;
        }
    }
    return Activity::Idle;
}

void TileMemory::count(const work::PlacedLine& line, bool write) {
    Counter& counter = line.depth ? (write ? statistics_.depth_stored : statistics_.depth_loaded)
                                  : (write ? statistics_.color_stored : statistics_.color_loaded);
    counter += line.bytes;
}

// The oldest bin that is not drawn yet.
Activity TileMemory::load() {
    const auto loading = std::find_if(
        open_.begin(), open_.end(), [](const Open& open) { return open.state == State::Loading; });
    if (loading == open_.end()) return Activity::Idle;
    if (!loading->token.empty) {
        if (loading->clear_cycles > 0) {
            --loading->clear_cycles;
            return Activity::Busy;
        }
        if (loading->on_their_way > 0 || loading->next_line != loading->token.plan().loads_end)
            return Activity::StalledMemory;
        if (!ports_.bins_out.can_push()) return Activity::StalledOutput;
        ports_.bins_out.push(loading->token);
    }
    loading->state = State::Drawing;
    return Activity::Busy;
}

// The oldest bin: drawn, stored, gone.
Activity TileMemory::close() {
    if (open_.empty()) return Activity::Idle;
    Open& first = open_.front();
    const PassToken& pass = first.token.pass;
    if (first.state == State::Drawing) {
        if (!first.token.empty && !pass.scene->bin_is_drawn(first.token.bin, now()))
            return Activity::StalledOutput;
        first.state = State::Storing;
        first.next_line = first.token.empty ? 0 : first.token.plan().stores_begin;
        return Activity::Busy;
    }
    if (first.state != State::Storing) return Activity::Idle;
    if (!first.token.empty && first.next_line != first.token.plan().stores_end)
        return Activity::Idle;
    if (first.token.last_of_pass) {
        if (!ports_.free_buffers_out.can_push()) return Activity::StalledOutput;
        ports_.free_buffers_out.push(pass.buffer);
        if (pass.is_last()) in_flight_.leave();
        pass.scene->end_pass();
    }
    open_.pop_front();
    return Activity::Busy;
}

Activity TileMemory::move_lines() {
    Activity last = move_line();
    const Activity activity = last;
    for (std::uint32_t moved = 1; moved < config_.lines_per_cycle && last == Activity::Busy;
         ++moved)
        last = move_line();
    return activity;
}

Activity TileMemory::step() {
    while (ports_.responses_in.can_pop())
        --open_[ports_.responses_in.pop() - open_.front().ticket].on_their_way;
    Activity reason = Activity::Idle;
    bool worked = open_bin();
    for (const Activity activity : {close(), move_lines(), load()}) {
        worked |= activity == Activity::Busy;
        if (activity != Activity::Busy && activity != Activity::Idle) blame(reason, activity);
    }
    return worked ? Activity::Busy : reason;
}

} // namespace ffgpu::timing
