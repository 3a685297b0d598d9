// MemoryArbiter: takes the clients' requests in turn (round robin) and sends them to the memory
// through a TLM-2.0 socket: in a cycle as many as there are memory channels, of any clients to any
// channels that take them. A client's requests go in their order. It counts what each client asked
// for and how long it waited, whatever memory is bound to the socket.
//
// The protocol is the base protocol's, without END_RESP: the memory answers BEGIN_REQ with
// TLM_UPDATED and END_REQ, or takes the request later by END_REQ on the backward path; when all is
// done it calls BEGIN_RESP. Reads and writes are both answered, in any order. A memory of ours can
// be told so without the socket (direct_memory.h).

#pragma once

#include "model/timing/channel.h"
#include "model/timing/command_ledger.h"
#include "model/timing/config.h"
#include "model/timing/direct_memory.h"
#include "model/timing/in_flight.h"
#include "model/timing/memory/address_mapping.h"
#include "model/timing/memory_module.h"
#include "model/timing/memory_observer.h"
#include "model/timing/memory_payload.h"
#include "model/timing/memory_request.h"
#include "model/timing/memory_statistics.h"
#include "model/timing/unit.h"

#include <vector>

#include <tlm_utils/simple_initiator_socket.h>

namespace ffgpu::timing {

class MemoryArbiter final : public Unit, private DirectClient {
public:
    struct Ports {
        // A port each, of one client or another; responses are tickets of reads that are done, null
        // where a port only writes.
        std::vector<Channel<MemoryRequest>*> requests_in;
        std::vector<Channel<std::uint64_t>*> responses_out;
    };

    MemoryArbiter(sc_core::sc_module_name name,
                  const Clock& clock,
                  const MemoryConfig& config,
                  Ports ports,
                  InFlight& in_flight);

    tlm_utils::simple_initiator_socket<MemoryArbiter> socket{"socket"};
    // To the memory that is bound to the socket, past it where that can be.
    void go_directly(MemoryModule& memory) { direct_ = memory.go_directly(*this); }
    std::string state() const override;
    bool waits_outside() const override { return pool_.first_used() != nullptr; }
    const ClientStatistics& statistics() const {
        statistics_.count_done();
        return statistics_;
    }
    // Null: nobody.
    void set_observer(MemoryObserver* observer) { observer_ = observer; }
    // The machine's own, who looks what is waited for; null: nobody.
    void set_waits(MemoryObserver* waits) { waits_ = waits; }
    void set_ledger(CommandLedger* ledger) { ledger_ = ledger; }
    // Neither its statistics nor the ledger are told of requests.
    void leave_out_figures() {
        counts_ = false;
        ledger_ = nullptr;
    }

private:
    Activity step() override;
    // `wanting`: ports with a request, a bit each.
    std::uint32_t send_round(std::uint64_t& wanting, std::uint32_t most);
    std::uint32_t send_of_one(std::uint64_t& wanting, std::uint32_t most);
    void send(std::size_t port, std::uint32_t channel);
    bool send_by_socket(const RequestTag& tag);
    bool is_free(std::uint32_t channel) const {
        return !pending_[channel] && taken_at_[channel] < now();
    }
    tlm::tlm_sync_enum
    on_backward(tlm::tlm_generic_payload& payload, tlm::tlm_phase& phase, sc_core::sc_time& delay);
    // DirectClient
    void taken(const RequestTag& tag) override;
    void done(RequestTag& tag) override;

    const AddressMapping mapping_;
    const std::uint32_t channels_;
    const Ports ports_;
    InFlight& in_flight_;
    PayloadPool pool_;
    DirectMemory* direct_ = nullptr;      // null: by the socket
    mutable ClientStatistics statistics_; // brought up to date when somebody asks
    MemoryObserver* observer_ = nullptr;
    MemoryObserver* waits_ = nullptr;
    CommandLedger* ledger_ = nullptr;
    bool counts_ = true;
    std::size_t next_port_ = 0;
    // Per memory channel: the request that it has not taken yet, and when it took one late.
    std::vector<const RequestTag*> pending_;
    std::vector<Cycle> taken_at_;
};

} // namespace ffgpu::timing
