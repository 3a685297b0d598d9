// MemoryController: DRAM channels with banks and open rows behind a TLM-2.0 target socket.
//
// Each channel serves its queue first-ready first-come-first-served (S. Rixner et al., Memory
// Access Scheduling, ISCA 2000): the oldest request whose row is open, else the oldest. A request
// costs what its bank needs (precharge, activate, column access), the turnaround between read and
// write, and the data bus for its bytes.

#pragma once

#include "model/timing/channel.h"
#include "model/timing/config.h"
#include "model/timing/memory_payload.h"
#include "model/timing/unit.h"

#include <deque>
#include <memory>
#include <string>
#include <vector>

#include <tlm_utils/simple_target_socket.h>

namespace ffgpu::timing {

class MemoryStatistics : public StatisticsGroup {
    std::deque<std::string> names_;

    Counter&
    of_client(std::size_t client, const char* name, const char* unit, const char* meaning) {
        return count(names_.emplace_back("memory_" + std::string(ClientNames[client]) + '_' + name),
                     unit,
                     meaning);
    }

public:
    MemoryStatistics() {
        for (std::size_t client = 0; client < Clients; ++client) {
            read_bytes[client] = &of_client(client, "read_bytes", "bytes", "read for this client");
            written_bytes[client] =
                &of_client(client, "written_bytes", "bytes", "written for this client");
            requests[client] =
                &of_client(client, "requests", "requests", "reads and writes of this client");
            latency[client] = &of_client(client,
                                         "read_latency_cycles",
                                         "cycles",
                                         "sum over its reads, from arbiter to data");
        }
    }

    std::array<Counter*, Clients> read_bytes, written_bytes, requests, latency;
    Counter& row_hits = count("memory_row_hits", "requests", "that found their row open");
    Counter& row_misses = count("memory_row_misses", "requests", "that had to open their row");
    Counter& turnarounds =
        count("memory_turnarounds", "changes", "of a bus between read and write");
    Counter& data_cycles =
        count("memory_data_cycles", "cycles", "of data on the buses, over all channels");
};

class MemoryController final : public Unit {
public:
    MemoryController(sc_core::sc_module_name name, const Clock& clock, const MemoryConfig& config);

    tlm_utils::simple_target_socket<MemoryController> socket{"socket"};
    const MemoryStatistics& statistics() const { return statistics_; }

    // The queues' producer, so that a freed place wakes it.
    void connect(Unit& arbiter);

private:
    struct Bank {
        static constexpr std::uint64_t Closed = ~std::uint64_t{0};
        std::uint64_t open_row = Closed;
        Cycle ready_at = 0;
    };
    struct Response {
        Cycle at = 0;
        tlm::tlm_generic_payload* payload = nullptr;
    };
    struct Burst {
        Cycle begin = 0, end = 0;
    };
    struct DramChannel {
        std::unique_ptr<Channel<tlm::tlm_generic_payload*>> arrivals;
        std::deque<tlm::tlm_generic_payload*> queue;
        tlm::tlm_generic_payload* refused = nullptr; // BEGIN_REQ that found the queue full
        std::vector<Bank> banks;
        Cycle bus_free_at = 0;
        bool last_was_write = false;
        std::deque<Burst> bursts;       // on the bus, or to come
        std::deque<Response> responses; // in the order of their data
    };

    Activity step() override;
    bool may_sleep() const override;
    tlm::tlm_sync_enum
    on_forward(tlm::tlm_generic_payload& payload, tlm::tlm_phase& phase, sc_core::sc_time& delay);
    void accept_arrivals(DramChannel& channel);
    void deliver(DramChannel& channel);
    bool issue(DramChannel& channel);
    bool carries_data(DramChannel& channel) const;
    Bank& bank_of(DramChannel& channel, std::uint64_t address) const;
    std::uint64_t row_of(std::uint64_t address) const;

    const MemoryConfig config_;
    std::vector<DramChannel> channels_;
    MemoryStatistics statistics_;
};

} // namespace ffgpu::timing
