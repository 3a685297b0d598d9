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
    , lanes_(config.channels)
    , plainly_(clock.pace() == Pace::EveryCycle) {
    const Cycle there = 1 + config.latency / 2;
    for (std::uint32_t number = 0; number < config.channels; ++number) {
        lanes_[number].arrivals = std::make_unique<Channel<tlm::tlm_generic_payload*>>(
            clock, config.queue + (arrivals > 0 ? arrivals : there), there);
        lanes_[number].dram = std::make_unique<DramChannel>(config_, number, statistics_, plainly_);
    }
    socket_.register_nb_transport_fw(this, &MemoryController::on_forward);
}

void MemoryController::connect(Unit& arbiter) {
    for (std::size_t number = 0; number < lanes_.size(); ++number) {
        lanes_[number].arrivals->connect(
            "memory_channel" + std::to_string(number) + "_arrivals", arbiter, *this);
        lanes_[number].arrivals->leave_asleep();
    }
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
    if (lane.arrivals->is_full() && !is_in_time(lane)) accept_arrivals(lane, now() - 1);
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
    const Cycle arrives = now() + lane.arrivals->latency();
    if (is_in_time(lane)) return wake(arrives);
    lane.due = std::min(lane.due, std::max(arrives, first_answer(memory_time(arrives - 1))));
    wake(lane.due);
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

// Each in the cycle in which it comes, or in the one behind that in which the queue has room.
void MemoryController::accept_arrivals(Lane& lane, Cycle until) {
    while (lane.arrivals->arrival() <= until) {
        const Cycle at = std::max(lane.arrivals->arrival(), lane.room_at);
        if (at > until) return;
        const MemoryCycle begin = memory_time(at - 1);
        lane.dram->advance(begin);
        if (!lane.dram->has_room()) {
            const MemoryCycle freed = lane.dram->advance_to_room(memory_time(until));
            if (!lane.dram->has_room()) return;
            lane.room_at = core_time(freed) + 1;
            continue;
        }
        lane.dram->push(to_dram(config_, *lane.arrivals->front()), begin);
        lane.arrivals->drop(at);
    }
}

void MemoryController::accept_refused(Lane& lane) {
    if (!lane.refused || !lane.arrivals->can_push()) return;
    tlm::tlm_generic_payload& payload = *lane.refused;
    lane.refused = nullptr;
    send(lane, payload);
    tlm::tlm_phase phase = tlm::END_REQ;
    sc_core::sc_time delay = sc_core::SC_ZERO_TIME;
    socket_->nb_transport_bw(payload, phase, delay);
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
    accept_arrivals(lane, now());
    accept_refused(lane);
    lane.dram->advance(memory_time(now()));
    if (!lane.dram->served().empty()) answer(lane);
    while (!lane.carryings.empty() && lane.carryings.front().last < now())
        lane.carryings.pop_front();
    lane.moves = !lane.carryings.empty() && lane.carryings.front().first <= now();
    lane.waits = lane.dram->has_waiting() || !lane.carryings.empty() || lane.arrivals->can_pop();
    if (!lane.responses.empty() && lane.responses.front().at <= now()) deliver(lane);
    lane.due = next_work(lane);
}

bool MemoryController::is_due(const Lane& lane) const {
    return lane.due <= now() ||
           (is_in_time(lane) && lane.arrivals->can_pop() && lane.dram->has_room());
}

// Busy while a bus carries data; all else that it does for a request is a stall.
Activity MemoryController::step() {
    bool moving = false, waiting = false;
    next_work_ = Never;
    for (Lane& lane : lanes_) {
        if (is_due(lane)) step(lane);
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
        if (is_in_time(lane)) lane.dram->settle(end);
    statistics_.set_bus_cycles(end * config_.channels);
}

// When the channel has to be looked at for its next command: in the cycle in which that goes out,
// or before its answer could be back.
Cycle MemoryController::next_command(const Lane& lane) const {
    const MemoryCycle command = lane.dram->next_work();
    return is_in_time(lane) ? core_time(command + 1)
                            : std::max(core_time(command + 1), first_answer(command));
}

// Refreshes of a channel that nobody waits for are made up for when somebody does.
Cycle MemoryController::next_work(const Lane& lane) const {
    Cycle next = lane.responses.empty() ? Never : lane.responses.front().at;
    const Cycle arrival = lane.arrivals->arrival();
    if (is_in_time(lane)) {
        if (arrival <= now() && lane.dram->has_room()) return now() + 1;
        if (lane.refused && !lane.arrivals->is_full()) return now() + 1;
        if (arrival > now()) next = std::min(next, arrival);
    } else if (arrival != Never) {
        const Cycle taken = std::max(arrival, now() + 1);
        next = std::min(next, std::max(taken, first_answer(memory_time(taken - 1))));
    }
    if (lane.dram->has_waiting()) next = std::min(next, next_command(lane));
    if (!lane.carryings.empty()) { // to say that it carries data, or not any more
        const Carrying& carrying = lane.carryings.front();
        next = std::min(next, lane.moves ? carrying.last + 1 : carrying.first);
    }
    return std::max(next, now() + 1);
}

} // namespace ffgpu::timing
