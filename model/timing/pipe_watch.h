// PipeWatch: looks at the machine's stages at the end of each cycle in which a unit was called, and
// notes in a log what it saw. It never changes a cycle.

#pragma once

#include "model/timing/memory/config.h"
#include "model/timing/memory_observer.h"
#include "model/timing/pipe_log.h"
#include "model/timing/stage.h"
#include "model/timing/unit.h"

#include <vector>

namespace ffgpu::timing {

// What is looked at.
struct PipeParts {
    std::vector<Stage> stages; // in the order of the pipe
    // By the arbiter's ports; of a port that only writes null.
    std::vector<const Link*> requests, responses;
    Unit& arbiter;
    const Unit& drain; // waits for all that the memory is asked
    const MemoryConfig& memory;
    bool memory_is_ours;
};

class PipeWatch final : public MemoryObserver {
public:
    // From the first cycle on. Links are connected.
    PipeWatch(const Clock& clock, const PipeParts& parts);

    // What is seen from now on goes into this log, which is empty.
    void write_to(PipeLog& log);
    // The cycle is over, and belongs to this entry of the ledger.
    void end_cycle(std::size_t charged);
    // The log is as long as the processor's caches hold it, with room for another cycle.
    bool is_full() const {
        return next_.cycles >= full_.cycles || next_.stages >= full_.stages ||
               next_.links >= full_.links || next_.passages >= full_.passages;
    }
    // All that was seen is in the log.
    void finish_log();

    // MemoryObserver
    void sent(const MemoryRequest&, std::uint64_t) override {}
    void done(const MemoryRequest& request, std::uint64_t cycle) override;

private:
    // What is looked at, and as it was seen last.
    struct WatchedLink {
        const Link* link;
        std::uint64_t moves = 0; // items that came, and that went
    };
    struct WatchedPassage {
        const Passage* passage;
        std::uint32_t moves = 0;
    };
    struct Place {
        const Stage* stage;
        StageLinks ways;
        std::vector<const Link*> beside{}; // by which its unit gives, but not this stage
        std::vector<WatchedLink> links{};  // in, out, asked, answered
        std::vector<WatchedPassage> passages{};
        bool request_waits = false; // when something was noted of it last
    };
    // Places in the log.
    struct Room {
        CycleSeen* cycles = nullptr;
        StageSeen* stages = nullptr;
        LinkSeen* links = nullptr;
        Passage* passages = nullptr;
    };

    void note_stages(std::uint64_t called);
    // Of one that tells its steps nothing is noted where nothing moved, and no request waits or
    // did.
    static void look(Place& at, std::uint32_t place, Cycle now, Room& room);
    // Those that changed since, into the log; returns their bits.
    static std::uint64_t note_links(Place& place, Room& room);
    static std::uint64_t note_passages(Place& place, Room& room);
    // Returns the number of ports.
    std::uint32_t note_taken();

    const Clock& clock_;
    const PipeParts& parts_;
    std::vector<Place> places_;
    std::size_t links_ = 0, passages_ = 0; // of all places
    PipeLog* log_ = nullptr;
    Room next_, full_;                 // where what is noted next goes; from where on it is full
    std::vector<AnswerSeen> answers_;  // of the cycle
    std::vector<std::uint64_t> taken_; // by the arbiter's ports, before the cycle
    std::uint64_t called_ = 0;         // stages, a bit each, and the arbiter, whose units were
};

} // namespace ffgpu::timing
