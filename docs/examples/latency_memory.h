// Example of a memory of one's own: any number of requests at once, each answered after a time that
// a function gives. Bind it with
//     GpuTiming(config, 0, [](const Clock& clock, const MemoryConfig&) {
//         return std::make_unique<LatencyMemory>("mine", clock, [](const auto& request) { return
//         100; });
//     });

#pragma once

#include "model/timing/memory_module.h"
#include "model/timing/memory_payload.h"

#include <functional>
#include <map>
#include <utility>

#include <tlm_utils/simple_target_socket.h>

namespace ffgpu::examples {

class LatencyMemory final : public sc_core::sc_module, public timing::MemoryModule {
public:
    using Latency = std::function<timing::Cycle(const timing::MemoryRequest&)>;

    // Latencies in cycles of the machine; one at least.
    LatencyMemory(sc_core::sc_module_name name, const timing::Clock& clock, Latency latency)
        : sc_module(name)
        , clock_(clock)
        , latency_(std::move(latency)) {
        socket_.register_nb_transport_fw(this, &LatencyMemory::on_forward);
        SC_HAS_PROCESS(LatencyMemory);
        SC_METHOD(on_edge);
        sensitive << clock.edge();
        dont_initialize();
    }

    tlm::tlm_target_socket<>& target() override { return socket_; }

private:
    // Takes each request at once: BEGIN_REQ is answered with END_REQ.
    tlm::tlm_sync_enum
    on_forward(tlm::tlm_generic_payload& payload, tlm::tlm_phase& phase, sc_core::sc_time&) {
        const auto& request = payload.get_extension<timing::RequestTag>()->request;
        answers_.emplace(clock_.now() + latency_(request), &payload);
        phase = tlm::END_REQ;
        return tlm::TLM_UPDATED;
    }

    void on_edge() {
        while (!answers_.empty() && answers_.begin()->first <= clock_.now()) {
            tlm::tlm_generic_payload& payload = *answers_.begin()->second;
            answers_.erase(answers_.begin());
            payload.set_response_status(tlm::TLM_OK_RESPONSE);
            tlm::tlm_phase phase = tlm::BEGIN_RESP;
            sc_core::sc_time delay = sc_core::SC_ZERO_TIME;
            socket_->nb_transport_bw(payload, phase, delay);
        }
    }

    const timing::Clock& clock_;
    const Latency latency_;
    tlm_utils::simple_target_socket<LatencyMemory> socket_{"socket"};
    std::multimap<timing::Cycle, tlm::tlm_generic_payload*>
        answers_; // by the time that they are due
};

} // namespace ffgpu::examples
