// FixedMemory: a memory without limits: every request is taken at once and answered after
// memory.latency cycles, in the order in which they came.

#pragma once

#include "model/base/ring.h"
#include "model/timing/config.h"
#include "model/timing/memory_module.h"
#include "model/timing/unit.h"

#include <tlm_utils/simple_target_socket.h>

namespace ffgpu::timing {

class FixedMemory final : public Unit, public MemoryModule, private DirectMemory {
public:
    FixedMemory(sc_core::sc_module_name name, const Clock& clock, const MemoryConfig& config);

    tlm::tlm_target_socket<>& target() override { return socket_; }
    Unit* unit() override { return this; }
    DirectMemory* go_directly(DirectClient& client) override {
        client_ = &client;
        return this;
    }
    std::string state() const override;

private:
    struct Answer {
        Cycle at = 0;
        RequestTag* request = nullptr;
    };

    Activity step() override;
    Cycle next_work(Activity last) const override;
    tlm::tlm_sync_enum
    on_forward(tlm::tlm_generic_payload& payload, tlm::tlm_phase& phase, sc_core::sc_time& delay);
    // DirectMemory
    bool take(RequestTag& request, std::uint32_t channel) override;
    void answer_by_socket(RequestTag& request);

    DirectClient* client_ = nullptr; // null: who asks does so by the socket
    const Cycle latency_;
    Ring<Answer> answers_;
    tlm_utils::simple_target_socket<FixedMemory> socket_{"socket"};
};

} // namespace ffgpu::timing
