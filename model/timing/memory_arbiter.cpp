#include "model/timing/memory_arbiter.h"

#include <utility>

namespace ffgpu::timing {

MemoryArbiter::MemoryArbiter(sc_core::sc_module_name name,
                             const Clock& clock,
                             const MemoryConfig& config,
                             Ports ports,
                             InFlight& in_flight)
    : Unit(name, clock)
    , config_(config)
    , ports_(std::move(ports))
    , in_flight_(in_flight)
    , pending_(config.channels, nullptr)
    , taken_at_(config.channels, 0) {
    socket.register_nb_transport_bw(this, &MemoryArbiter::on_backward);
}

Activity MemoryArbiter::step() {
    bool waiting = false;
    bool sent = false;
    std::uint32_t free_channels = 0;
    for (std::uint32_t channel = 0; channel < config_.channels; ++channel)
        free_channels += is_free(channel) ? 1 : 0;

    const std::size_t first = next_port_, ports = ports_.requests_in.size();
    for (std::size_t i = 0; i < ports && free_channels > 0; ++i) {
        const std::size_t port = first + i < ports ? first + i : first + i - ports;
        Channel<MemoryRequest>& requests = *ports_.requests_in[port];
        if (!requests.can_pop()) continue;
        const std::uint32_t channel = memory_channel(config_, requests.front().address);
        if (!is_free(channel)) {
            waiting = true;
            continue;
        }
        MemoryRequest request = requests.pop();
        request.port = port;
        check(is_in_one_place(config_, request.address, request.bytes),
              "a request across an interleave or a row");
        tlm::tlm_generic_payload& payload = pool_.acquire(request);
        tlm::tlm_phase phase = tlm::BEGIN_REQ;
        sc_core::sc_time delay = sc_core::SC_ZERO_TIME;
        pending_[channel] = &payload;
        if (observer_) observer_->sent(request, now());
        if (socket->nb_transport_fw(payload, phase, delay) == tlm::TLM_UPDATED) {
            pending_[channel] = nullptr;
            taken_at_[channel] = now();
        }
        --free_channels;
        sent = true;
        next_port_ = port + 1 < ports ? port + 1 : 0;
    }
    if (sent) return Activity::Busy;
    for (const Channel<MemoryRequest>* requests : ports_.requests_in)
        waiting |= requests->can_pop();
    return waiting ? Activity::StalledOutput : Activity::Idle;
}

tlm::tlm_sync_enum MemoryArbiter::on_backward(tlm::tlm_generic_payload& payload,
                                              tlm::tlm_phase& phase,
                                              sc_core::sc_time&) {
    const MemoryRequest request = payload.get_extension<RequestTag>()->request;
    if (phase == tlm::END_REQ) {
        const std::uint32_t channel = memory_channel(config_, request.address);
        pending_[channel] = nullptr;
        taken_at_[channel] = now();
        wake();
        return tlm::TLM_ACCEPTED;
    }
    statistics_.on_done(request, now());
    if (observer_) observer_->done(request, now());
    if (!request.write) ports_.responses_out[request.port]->push(request.ticket);
    if (request.client != Client::ScanOut) in_flight_.leave(); // No frame waits for the screen.
    payload.release();
    return tlm::TLM_COMPLETED;
}

} // namespace ffgpu::timing
