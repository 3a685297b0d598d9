#include "model/timing/fixed_memory.h"

#include "model/timing/memory_payload.h"

#include <algorithm>

#include <fmt/format.h>

namespace ffgpu::timing {

FixedMemory::FixedMemory(sc_core::sc_module_name name,
                         const Clock& clock,
                         const MemoryConfig& config)
    : Unit(name, clock)
    , latency_(std::max<Cycle>(config.latency, 1)) {
    socket_.register_nb_transport_fw(this, &FixedMemory::on_forward);
}

tlm::tlm_sync_enum FixedMemory::on_forward(tlm::tlm_generic_payload& payload,
                                           tlm::tlm_phase& phase,
                                           sc_core::sc_time&) {
    RequestTag& request = *payload.get_extension<RequestTag>();
    request.payload = &payload; // where the client has made the tag
    take(request, 0);
    phase = tlm::END_REQ;
    return tlm::TLM_UPDATED;
}

bool FixedMemory::take(RequestTag& request, std::uint32_t) {
    if (answers_.empty()) wake(); // to say that it waits
    answers_.push_back({now() + latency_, &request});
    wake(now() + latency_);
    return true;
}

void FixedMemory::answer_by_socket(RequestTag& request) {
    request.payload->set_response_status(tlm::TLM_OK_RESPONSE);
    tlm::tlm_phase phase = tlm::BEGIN_RESP;
    sc_core::sc_time delay = sc_core::SC_ZERO_TIME;
    socket_->nb_transport_bw(*request.payload, phase, delay);
}

Activity FixedMemory::step() {
    bool answered = false;
    for (; !answers_.empty() && answers_.front().at <= now(); answered = true) {
        RequestTag& request = *answers_.front().request;
        answers_.pop_front();
        client_ ? client_->done(request) : answer_by_socket(request);
    }
    if (answered) return Activity::Busy;
    // One that came in this cycle is seen in the next, whoever is called first.
    const bool waits = !answers_.empty() && answers_.front().at - latency_ < now();
    return waits ? Activity::StalledMemory : Activity::Idle;
}

// A cycle more, to say that it answers no more.
Cycle FixedMemory::next_work(Activity last) const {
    if (last == Activity::Busy) return now() + 1;
    return answers_.empty() ? Never : answers_.front().at;
}

std::string FixedMemory::state() const {
    return answers_.empty() ? "nothing to answer"
                            : fmt::format("{} requests, the first answered in cycle {}",
                                          answers_.size(),
                                          answers_.front().at);
}

} // namespace ffgpu::timing
