#include "model/timing/memory_controller.h"

#include "model/timing/memory_arbiter.h"

#include <algorithm>

namespace ffgpu::timing {

MemoryController::MemoryController(sc_core::sc_module_name name,
                                   const Clock& clock,
                                   const MemoryConfig& config)
    : Unit(name, clock)
    , config_(config)
    , channels_(config.channels) {
    for (DramChannel& channel : channels_) {
        channel.arrivals = std::make_unique<Channel<tlm::tlm_generic_payload*>>(
            clock, config.queue, 1 + config.latency / 2);
        channel.banks.resize(config.banks);
    }
    socket.register_nb_transport_fw(this, &MemoryController::on_forward);
}

void MemoryController::connect(Unit& arbiter) {
    for (DramChannel& channel : channels_)
        channel.arrivals->connect(arbiter, *this);
}

tlm::tlm_sync_enum MemoryController::on_forward(tlm::tlm_generic_payload& payload,
                                                tlm::tlm_phase& phase,
                                                sc_core::sc_time&) {
    check(phase == tlm::BEGIN_REQ, "the arbiter only begins requests");
    DramChannel& channel = channels_[memory_channel(config_, payload.get_address())];
    wake();
    if (!channel.arrivals->can_push()) {
        channel.refused = &payload;
        return tlm::TLM_ACCEPTED;
    }
    channel.arrivals->push(&payload);
    phase = tlm::END_REQ;
    return tlm::TLM_UPDATED;
}

std::uint64_t MemoryController::row_of(std::uint64_t address) const {
    return address / (std::uint64_t{config_.row_bytes} * config_.channels * config_.banks);
}

MemoryController::Bank& MemoryController::bank_of(DramChannel& channel,
                                                  std::uint64_t address) const {
    const std::uint64_t row_of_channels = std::uint64_t{config_.row_bytes} * config_.channels;
    return channel.banks[(address / row_of_channels) & (config_.banks - 1)];
}

void MemoryController::accept_arrivals(DramChannel& channel) {
    while (channel.arrivals->can_pop() && channel.queue.size() < config_.queue)
        channel.queue.push_back(channel.arrivals->pop());
    if (channel.refused && channel.arrivals->can_push()) {
        tlm::tlm_generic_payload& payload = *channel.refused;
        channel.refused = nullptr;
        channel.arrivals->push(&payload);
        tlm::tlm_phase phase = tlm::END_REQ;
        sc_core::sc_time delay = sc_core::SC_ZERO_TIME;
        socket->nb_transport_bw(payload, phase, delay);
    }
}

void MemoryController::deliver(DramChannel& channel) {
    while (!channel.responses.empty() && channel.responses.front().at <= now()) {
        tlm::tlm_generic_payload& payload = *channel.responses.front().payload;
        channel.responses.pop_front();
        payload.set_response_status(tlm::TLM_OK_RESPONSE);
        tlm::tlm_phase phase = tlm::BEGIN_RESP;
        sc_core::sc_time delay = sc_core::SC_ZERO_TIME;
        socket->nb_transport_bw(payload, phase, delay);
    }
}

// Starts at most one request: its data take the bus as early as bank and bus allow. Requests are
// not started more than one ahead of the bus, so that later arrivals with open rows can pass.
bool MemoryController::issue(DramChannel& channel) {
    if (channel.queue.empty() || channel.bus_free_at > now() + config_.column_cycles) return false;
    const auto row_is_open = [&](const tlm::tlm_generic_payload* payload) {
        return bank_of(channel, payload->get_address()).open_row == row_of(payload->get_address());
    };
    auto chosen = std::find_if(channel.queue.begin(), channel.queue.end(), row_is_open);
    if (chosen == channel.queue.end()) chosen = channel.queue.begin();
    tlm::tlm_generic_payload& payload = **chosen;
    const bool hit = row_is_open(&payload);
    channel.queue.erase(chosen);

    const RequestTag& tag = *payload.get_extension<RequestTag>();
    const MemoryRequest& request = tag.request;
    Bank& bank = bank_of(channel, request.address);
    Cycle ready = std::max(now(), bank.ready_at);
    ++(hit ? statistics_.row_hits : statistics_.row_misses);
    if (!hit) {
        if (bank.open_row != Bank::Closed) ready += config_.precharge_cycles;
        ready += config_.row_to_column_cycles;
    }
    Cycle bus_free = channel.bus_free_at;
    if (channel.last_was_write != request.write) {
        bus_free += config_.turnaround_cycles;
        ++statistics_.turnarounds;
    }
    const Cycle data_begin = std::max(ready + config_.column_cycles, bus_free);
    const Cycle data_cycles =
        (request.bytes + config_.bytes_per_cycle - 1) / config_.bytes_per_cycle;
    const Cycle data_end = data_begin + data_cycles;
    channel.bus_free_at = data_end;
    channel.bursts.push_back({data_begin, data_end});
    channel.last_was_write = request.write;
    const bool closes = config_.page_policy == PagePolicy::Closed;
    bank.open_row = closes ? Bank::Closed : row_of(request.address);
    bank.ready_at = data_end + (closes ? config_.precharge_cycles : 0);

    const auto client = static_cast<std::size_t>(request.client);
    const Cycle response_at = data_end + config_.latency - config_.latency / 2;
    statistics_.data_cycles += data_cycles;
    ++*statistics_.requests[client];
    *(request.write ? statistics_.written_bytes : statistics_.read_bytes)[client] += request.bytes;
    if (!request.write) *statistics_.latency[client] += response_at - tag.issued;
    channel.responses.push_back({response_at, &payload});
    return true;
}

bool MemoryController::carries_data(DramChannel& channel) const {
    while (!channel.bursts.empty() && channel.bursts.front().end <= now())
        channel.bursts.pop_front();
    return !channel.bursts.empty() && channel.bursts.front().begin <= now();
}

// Busy while a bus carries data; what is spent on rows, columns and turnarounds is a stall.
Activity MemoryController::step() {
    bool moving = false, waiting = false;
    for (DramChannel& channel : channels_) {
        deliver(channel);
        accept_arrivals(channel);
        issue(channel);
        moving |= carries_data(channel);
        waiting |= !channel.queue.empty() || !channel.bursts.empty() || channel.arrivals->can_pop();
    }
    return moving ? Activity::Busy : waiting ? Activity::StalledMemory : Activity::Idle;
}

bool MemoryController::may_sleep() const {
    return std::ranges::all_of(channels_, [](const DramChannel& channel) {
        return channel.queue.empty() && channel.responses.empty() &&
               channel.arrivals->holds_nothing() && !channel.refused;
    });
}

} // namespace ffgpu::timing
