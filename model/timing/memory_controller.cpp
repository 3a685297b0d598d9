#include "model/timing/memory_controller.h"

#include "model/timing/memory/address_mapping.h"

#include <algorithm>

namespace ffgpu::timing {

DramRequest to_dram(const MemoryConfig& config, tlm::tlm_generic_payload& payload) {
    const MemoryRequest& request = payload.get_extension<RequestTag>()->request;
    const DramPlace place = place_of(config, request.address);
    return {.bank = place.bank,
            .row = place.row,
            .offset = static_cast<std::uint32_t>(row_offset(config, request.address)),
            .bytes = request.bytes,
            .write = request.write,
            .client = static_cast<std::uint32_t>(request.client),
            .payload = &payload};
}

MemoryController::MemoryController(sc_core::sc_module_name name,
                                   const Clock& clock,
                                   const MemoryConfig& config,
                                   std::size_t arrivals)
    : Unit(name, clock)
    , config_(config)
    , statistics_(config_)
    , lanes_(config.channels) {
    const Cycle there = 1 + config.latency / 2;
    for (std::uint32_t number = 0; number < config.channels; ++number) {
        lanes_[number].arrivals = std::make_unique<Channel<tlm::tlm_generic_payload*>>(
            clock, config.queue + (arrivals > 0 ? arrivals : there), there);
        lanes_[number].dram = std::make_unique<DramChannel>(
            config_, number, statistics_, clock.pace() == Pace::EveryCycle);
    }
    socket_.register_nb_transport_fw(this, &MemoryController::on_forward);
}

void MemoryController::connect(Unit& arbiter) {
    for (std::size_t number = 0; number < lanes_.size(); ++number)
        lanes_[number].arrivals->connect(
            "memory_channel" + std::to_string(number) + "_arrivals", arbiter, *this);
}

// Nor does the unit account for the cycles in which a bus carries data.
void MemoryController::leave_out_figures() {
    counts_ = false;
    for (Lane& lane : lanes_)
        lane.dram->leave_out_figures();
}

void MemoryController::set_command_observer(DramCommandObserver* observer) {
    commands_are_observed_ = observer != nullptr;
    for (Lane& lane : lanes_)
        lane.dram->set_command_observer(observer);
}

tlm::tlm_sync_enum MemoryController::on_forward(tlm::tlm_generic_payload& payload,
                                                tlm::tlm_phase& phase,
                                                sc_core::sc_time&) {
    check(phase == tlm::BEGIN_REQ, "the arbiter only begins requests");
    Lane& lane = lanes_[memory_channel(config_, payload.get_address())];
    if (!lane.arrivals->can_push()) {
        lane.refused = &payload;
        lane.due = std::min(lane.due, now() + 1);
        wake();
        return tlm::TLM_ACCEPTED;
    }
    send(lane, payload);
    phase = tlm::END_REQ;
    return tlm::TLM_UPDATED;
}

void MemoryController::send(Lane& lane, tlm::tlm_generic_payload& payload) {
    lane.arrivals->push(&payload);
}

void MemoryController::start(Lane& lane, MemoryCycle at) {
    lane.dram->push(to_dram(config_, *lane.arrivals->pop()), at);
}

// When a column has gone out all is known of its request: when the bus carries its data, and when
// the answer is back.
void MemoryController::answer(Lane& lane) {
    Ring<ServedRequest>& served = lane.dram->served();
    for (; !served.empty(); served.pop_front()) {
        const auto& [request, data] = served.front();
        const Cycle last = core_time(data.end);
        if (tells_carrying()) carry(lane, {std::max(core_time(data.begin + 1), now()), last});
        lane.responses.push_back(
            {last + way_back(), static_cast<tlm::tlm_generic_payload*>(request.payload)});
    }
}

void MemoryController::carry(Lane& lane, const Carrying& carrying) {
    if (lane.carryings.empty() || lane.carryings.back().last + 1 < carrying.first)
        lane.carryings.push_back(carrying);
    else
        lane.carryings.back().last = carrying.last;
}

void MemoryController::accept_arrivals(Lane& lane, MemoryCycle at) {
    while (lane.arrivals->can_pop() && lane.dram->has_room())
        start(lane, at);
    if (lane.refused && lane.arrivals->can_push()) {
        tlm::tlm_generic_payload& payload = *lane.refused;
        lane.refused = nullptr;
        send(lane, payload);
        tlm::tlm_phase phase = tlm::END_REQ;
        sc_core::sc_time delay = sc_core::SC_ZERO_TIME;
        socket_->nb_transport_bw(payload, phase, delay);
    }
}

void MemoryController::deliver(Lane& lane) {
    while (!lane.responses.empty() && lane.responses.front().at <= now()) {
        tlm::tlm_generic_payload& payload = *lane.responses.front().payload;
        lane.responses.pop_front();
        payload.set_response_status(tlm::TLM_OK_RESPONSE);
        tlm::tlm_phase phase = tlm::BEGIN_RESP;
        sc_core::sc_time delay = sc_core::SC_ZERO_TIME;
        socket_->nb_transport_bw(payload, phase, delay);
    }
}

void MemoryController::step(Lane& lane) {
    const MemoryCycle begin = memory_time(now() - 1), end = memory_time(now());
    lane.dram->advance(begin); // What went by while asleep: refreshes.
    if (lane.refused || (lane.arrivals->can_pop() && lane.dram->has_room()))
        accept_arrivals(lane, begin);
    lane.dram->advance(end);
    if (!lane.dram->served().empty()) answer(lane);
    while (!lane.carryings.empty() && lane.carryings.front().last < now())
        lane.carryings.pop_front();
    lane.moves = !lane.carryings.empty() && lane.carryings.front().first <= now();
    lane.waits = lane.dram->has_waiting() || !lane.carryings.empty() || lane.arrivals->can_pop();
    if (!lane.responses.empty() && lane.responses.front().at <= now()) deliver(lane);
    lane.due = next_work(lane);
    lane.is_behind = lane.dram->has_waiting() && lane.due > core_time(lane.dram->next_work() + 1);
}

// Busy while a bus carries data; all else that it does for a request is a stall.
Activity MemoryController::step() {
    bool moving = false, waiting = false;
    next_work_ = Never;
    for (Lane& lane : lanes_) {
        if (lane.is_due(now())) step(lane);
        moving |= lane.moves;
        waiting |= lane.waits;
        next_work_ = std::min(next_work_, lane.due);
    }
    return moving ? Activity::Busy : waiting ? Activity::StalledMemory : Activity::Idle;
}

void MemoryController::settle() {
    Unit::settle();
    const MemoryCycle end = memory_time(now());
    for (Lane& lane : lanes_)
        lane.dram->settle(end);
    statistics_.set_bus_cycles(end * config_.channels);
}

// When the channel has to be looked at for its next command: in the cycle in which that goes out;
// but where nobody asks what the bus does, and nothing waits for a place, it is enough to be there
// before an answer could be back. What went out until then is made up for, then or when something
// arrives.
Cycle MemoryController::next_command(const Lane& lane) const {
    const MemoryCycle command = lane.dram->next_work();
    if (tells_carrying() || lane.refused || lane.arrivals->can_pop()) return core_time(command + 1);
    const MemoryCycle least = std::min(config_.column_cycles, config_.write_column_cycles);
    return std::max(core_time(command + 1), core_time(command + least + 1) + way_back());
}

// Refreshes of a channel that nobody waits for are made up for when somebody does.
Cycle MemoryController::next_work(const Lane& lane) const {
    if (lane.arrivals->can_pop() && lane.dram->has_room()) return now() + 1;
    if (lane.refused && !lane.arrivals->is_full()) return now() + 1;
    Cycle next = lane.responses.empty() ? Never : lane.responses.front().at;
    if (lane.dram->has_waiting()) next = std::min(next, next_command(lane));
    if (!lane.carryings.empty()) { // to say that it carries data, or not any more
        const Carrying& carrying = lane.carryings.front();
        next = std::min(next, lane.moves ? carrying.last + 1 : carrying.first);
    }
    return std::max(next, now() + 1);
}

} // namespace ffgpu::timing
