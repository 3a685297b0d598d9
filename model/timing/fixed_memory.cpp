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
    if (answers_.empty()) wake(); // to say that it waits
    answers_.push_back({now() + latency_, &payload});
    wake(now() + latency_);
    phase = tlm::END_REQ;
    return tlm::TLM_UPDATED;
}

Activity FixedMemory::step() {
    bool answered = false;
    for (; !answers_.empty() && answers_.front().at <= now(); answered = true) {
        tlm::tlm_generic_payload& payload = *answers_.front().payload;
        answers_.pop_front();
        payload.set_response_status(tlm::TLM_OK_RESPONSE);
        tlm::tlm_phase phase = tlm::BEGIN_RESP;
        sc_core::sc_time delay = sc_core::SC_ZERO_TIME;
        socket_->nb_transport_bw(payload, phase, delay);
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
