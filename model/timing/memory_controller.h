// MemoryController: the timed shell of the memory. Requests come through a TLM-2.0 target socket,
// or past it (direct_memory.h), take half of `latency` to their channel's queue, are served there
// (memory/dram_channel.h), and take the other half back. Both ways hold as many requests as they
// are long.

#pragma once

#include "model/base/ring.h"
#include "model/timing/channel.h"
#include "model/timing/config.h"
#include "model/timing/memory/address_mapping.h"
#include "model/timing/memory/dram_channel.h"
#include "model/timing/memory_module.h"
#include "model/timing/memory_payload.h"
#include "model/timing/memory_statistics.h"

#include <algorithm>
#include <memory>
#include <vector>

#include <tlm_utils/simple_target_socket.h>

namespace ffgpu::timing {

// The request as its channel sees it.
DramRequest to_dram(const MemoryConfig& config, tlm::tlm_generic_payload& payload);

class MemoryController final : public Unit, public MemoryModule, private DirectMemory {
public:
    // `arrivals`: requests that a channel holds before its queue, beside those on their way; 0: as
    // many as are on their way.
    MemoryController(sc_core::sc_module_name name,
                     const Clock& clock,
                     const MemoryConfig& config,
                     std::size_t arrivals = 0);

    tlm::tlm_target_socket<>& target() override { return socket_; }
    Unit* unit() override { return this; }
    // The queues' producer, so that a freed place wakes it.
    void connect(Unit& arbiter) override;
    DirectMemory* go_directly(DirectClient& client) override {
        client_ = &client;
        return this;
    }
    void settle() override;
    std::string state() const override;
    void leave_out_figures() override;
    void set_command_observer(DramCommandObserver* observer) override;
    std::vector<const StatisticsGroup*> statistics() const override;

private:
    struct Response {
        Cycle at = 0;
        RequestTag* request = nullptr;
    };
    // Cycles of the core, from the first to the last, in each of which the bus carries data.
    struct Carrying {
        Cycle first = 0, last = 0;
    };
    struct Lane {
        std::unique_ptr<Channel<RequestTag*>> arrivals;
        RequestTag* refused = nullptr; // It found no place.
        std::unique_ptr<DramChannel> dram;
        Ring<Response> responses; // in the order of their data
        Ring<Carrying> carryings; // from the one of this cycle on, gaps between them
        // What the last look at the lane said.
        bool moves = false;
        bool is_behind = false; // Columns may have gone out that were not looked at yet.

        Cycle command_at = 0; // The channel does something.
        // When each part has to be looked at again, and the first of these.
        Cycle column_at = Never; // the channel, for what it does
        Cycle arrival_at = Never;
        Cycle carrying_at = Never;
        Cycle answer_at = Never;
        Cycle due = 0;

        bool is_waiting() const {
            return dram->has_waiting() || carrying_at != Never || arrivals->can_pop();
        }
        // An arrival is looked at where the channel takes it, or has to be made up for.
        bool looks_at_arrivals() const { return is_behind || dram->has_room(); }
    };

    Activity step() override;
    Cycle next_work(Activity) const override { return next_work_; }
    void step(Lane& lane);
    void work(Lane& lane);
    void look_ahead(Lane& lane);
    void note_carrying(Lane& lane);
    Cycle next_arrival(const Lane& lane) const;
    Cycle next_command(const Lane& lane) const;
    void look_at_arrival(Lane& lane, Cycle at);
    tlm::tlm_sync_enum
    on_forward(tlm::tlm_generic_payload& payload, tlm::tlm_phase& phase, sc_core::sc_time& delay);
    // DirectMemory
    bool take(RequestTag& request, std::uint32_t channel) override;
    void start(Lane& lane, MemoryCycle at);
    // Else nobody sees whether a bus carries data. Commands of several channels come as mixed as
    // with that: looks at a channel make up for its refreshes.
    bool tells_carrying() const { return counts_ || is_observed() || commands_are_observed_; }
    void answer(Lane& lane);
    Cycle way_back() const { return config_.latency - config_.latency / 2; }
    static void carry(Lane& lane, const Carrying& carrying);
    void accept_arrivals(Lane& lane, MemoryCycle at);
    void deliver(Lane& lane);
    void say(RequestTag& request, tlm::tlm_phase phase);
    // Memory cycles that are over when core cycle `now` is.
    MemoryCycle memory_time(Cycle now) const {
        if (config_.memory_clocks == config_.core_clocks) return now;
        return now * config_.memory_clocks / config_.core_clocks;
    }
    // The first core cycle that is not over before memory cycle `end` is.
    Cycle core_time(MemoryCycle end) const {
        if (config_.memory_clocks == config_.core_clocks) return end;
        return (end * config_.core_clocks + config_.memory_clocks - 1) / config_.memory_clocks;
    }

    const MemoryConfig config_;
    const AddressMapping mapping_;
    DirectClient* client_ = nullptr; // null: who asks does so by the socket
    tlm_utils::simple_target_socket<MemoryController> socket_{"socket"};
    mutable DramStatistics statistics_; // brought up to date when somebody asks
    std::vector<Lane> lanes_;
    Cycle next_work_ = 0; // of all lanes
    Activity activity_ = Activity::Idle;
    bool counts_ = true;
    bool commands_are_observed_ = false;
};

} // namespace ffgpu::timing
