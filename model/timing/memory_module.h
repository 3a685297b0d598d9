// MemoryModule: what the machine needs to know of the memory behind its TLM-2.0 socket. Ours is
// MemoryController; docs/units/memory.md shows how to bind another one.

#pragma once

#include "model/base/statistics.h"
#include "model/timing/direct_memory.h"
#include "model/timing/memory_request.h"
#include "model/timing/unit.h"

#include <functional>
#include <memory>
#include <tlm>
#include <vector>

namespace ffgpu::timing {

class DramCommandObserver; // memory/dram_commands.h
struct MemoryConfig;

class MemoryModule {
public:
    virtual ~MemoryModule() = default;

    // Where the arbiter's socket is bound; memory_arbiter.h names the protocol.
    virtual tlm::tlm_target_socket<>& target() = 0;

    // A unit of the machine keeps an account and is evaluated with the others; other memories look
    // after their processes themselves.
    virtual Unit* unit() { return nullptr; }
    // The arbiter sleeps until a channel wakes it.
    virtual void connect(Unit&) {}
    // From now on this client's requests come past the socket, which stays bound; null: they do
    // not. Before the first.
    virtual DirectMemory* go_directly(DirectClient&) { return nullptr; }
    // A frame has ended: bring the statistics up to date.
    virtual void settle() {}
    // Nobody will read the statistics.
    virtual void leave_out_figures() {}
    // Of a DRAM of ours; null: nobody.
    virtual void set_command_observer(DramCommandObserver*) {}
    virtual std::vector<const StatisticsGroup*> statistics() const { return {}; }
};

// Called while the machine is built, within its SystemC context.
using MakeMemory = std::function<std::unique_ptr<MemoryModule>(const Clock&, const MemoryConfig&)>;

} // namespace ffgpu::timing
