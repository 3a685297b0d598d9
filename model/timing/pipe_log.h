// PipeLog: what was seen of the machine's stages, cycle after cycle: all that the search for
// bottlenecks reads of a machine that runs on meanwhile.

#pragma once

#include "model/timing/account.h"
#include "model/timing/command_ledger.h"
#include "model/timing/memory_request.h"
#include "model/timing/passage.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ffgpu::timing {

// A link at the end of a cycle. Items since the machine's start, modulo 2^32.
struct LinkSeen {
    std::uint32_t pushed = 0, popped = 0;
};

// A stage whose unit was called in the cycle. Its links follow: in, out, asked, answered; of those
// by which work comes in, when the oldest item arrives; and those of the passages between its steps
// that changed.
struct StageSeen {
    std::uint32_t stage = 0;
    Activity activity = Activity::Idle;
    std::uint64_t passages = 0; // that changed: a bit each
    bool refused = false;       // by one of its ways out
    bool unit_refused = false;  // by any of its unit's
    bool request_waits = false; // of its unit, for a place on the way to the memory
    bool has_backlog = false;
};

// A port of the arbiter by which it took requests.
struct TakenSeen {
    std::size_t port = 0;
    LinkSeen link;
};

// A request whose data came, or were written.
struct AnswerSeen {
    MemoryRequest request;
    LinkSeen back; // by which it is answered, before the answer goes in; none where nobody is
};

struct CycleSeen {
    Cycle now = 0;
    std::size_t charged = CommandLedger::Nobody; // entry of the ledger, that the cycle belongs to
    std::uint32_t answers = 0, stages = 0, taken = 0;
};

struct PipeLog {
    std::vector<CycleSeen> cycles;
    std::vector<AnswerSeen> answers;
    std::vector<StageSeen> stages;
    std::vector<LinkSeen> links;
    std::vector<Cycle> arrivals; // Never: of none
    std::vector<Passage> passages;
    std::vector<TakenSeen> taken;

    void clear() {
        cycles.clear();
        answers.clear();
        stages.clear();
        links.clear();
        arrivals.clear();
        passages.clear();
        taken.clear();
    }
};

} // namespace ffgpu::timing
