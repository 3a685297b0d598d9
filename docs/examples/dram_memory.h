// Example of a memory of one's own that reproduces MemoryController: a plain SystemC module with a
// TLM-2.0 target socket, made of the same DRAM channels (model/timing/memory). From here one can
// replace what one studies: the scheduler, the mapping of addresses, the whole DRAM.

#pragma once

#include "model/timing/channel.h"
#include "model/timing/memory/address_mapping.h"
#include "model/timing/memory_controller.h"

#include <deque>
#include <map>
#include <utility>
#include <vector>

#include <tlm_utils/simple_target_socket.h>

namespace ffgpu::examples {

class DramMemory final : public sc_core::sc_module, public timing::MemoryModule {
public:
    using Payload = tlm::tlm_generic_payload;

    DramMemory(sc_core::sc_module_name name,
               const timing::Clock& clock,
               const timing::MemoryConfig& config)
        : sc_module(name)
        , clock_(clock)
        , config_(config)
        , statistics_(config_)
        , refused_(config.channels, nullptr) {
        const timing::Cycle there = 1 + config.latency / 2;
        for (std::uint32_t number = 0; number < config.channels; ++number) {
            arriving_.emplace_back(clock, config.queue + there, there);
            drams_.emplace_back(config_, number, statistics_);
        }
        socket_.register_nb_transport_fw(this, &DramMemory::on_forward);
        SC_HAS_PROCESS(DramMemory);
        SC_METHOD(on_edge);
        sensitive << clock.edge();
        dont_initialize();
    }

    tlm::tlm_target_socket<>& target() override { return socket_; }
    void settle() override {
        for (timing::DramChannel& dram : drams_)
            dram.settle(memory_time());
        statistics_.set_bus_cycles(memory_time() * config_.channels);
    }
    std::vector<const StatisticsGroup*> statistics() const override { return {&statistics_}; }

private:
    timing::MemoryCycle memory_time() const {
        return clock_.now() * config_.memory_clocks / config_.core_clocks;
    }

    // Takes a request if its channel has a place, else later: END_REQ on the backward path.
    tlm::tlm_sync_enum on_forward(Payload& payload, tlm::tlm_phase& phase, sc_core::sc_time&) {
        const std::uint32_t number = timing::memory_channel(config_, payload.get_address());
        if (!arriving_[number].can_push()) {
            refused_[number] = &payload;
            return tlm::TLM_ACCEPTED;
        }
        arriving_[number].push(&payload);
        phase = tlm::END_REQ;
        return tlm::TLM_UPDATED;
    }

    void on_edge() {
        const timing::MemoryCycle begin =
            (clock_.now() - 1) * config_.memory_clocks / config_.core_clocks;
        for (std::uint32_t number = 0; number < config_.channels; ++number) {
            timing::DramChannel& dram = drams_[number];
            dram.advance(begin);
            while (arriving_[number].can_pop() && dram.has_room())
                dram.push(timing::to_dram(config_, *arriving_[number].pop()), begin);
            if (refused_[number] && arriving_[number].can_push()) {
                arriving_[number].push(refused_[number]);
                say(*std::exchange(refused_[number], nullptr), tlm::END_REQ);
            }
            dram.advance(memory_time());
            take_served(dram.served());
        }
        for (; !answers_.empty() && answers_.begin()->first <= clock_.now();
             answers_.erase(answers_.begin())) {
            answers_.begin()->second->set_response_status(tlm::TLM_OK_RESPONSE);
            say(*answers_.begin()->second, tlm::BEGIN_RESP);
        }
    }

    void take_served(Ring<timing::ServedRequest>& served) {
        const timing::Cycle back = config_.latency - config_.latency / 2;
        for (; !served.empty() && served.front().data.end <= memory_time(); served.pop_front())
            answers_.emplace(clock_.now() + back,
                             static_cast<Payload*>(served.front().request.payload));
    }

    void say(Payload& payload, tlm::tlm_phase phase) {
        sc_core::sc_time delay = sc_core::SC_ZERO_TIME;
        socket_->nb_transport_bw(payload, phase, delay);
    }

    const timing::Clock& clock_;
    const timing::MemoryConfig config_;
    timing::DramStatistics statistics_;
    std::deque<timing::Channel<Payload*>> arriving_; // a deque: neither can be moved
    std::deque<timing::DramChannel> drams_;
    std::vector<Payload*> refused_;
    std::multimap<timing::Cycle, Payload*> answers_; // by the time that they are due
    tlm_utils::simple_target_socket<DramMemory> socket_{"socket"};
};

} // namespace ffgpu::examples
