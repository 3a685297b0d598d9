// PipeLog: what was seen of the machine's stages, cycle after cycle: all that the search for
// bottlenecks reads of a machine that runs on meanwhile.

#pragma once

#include "model/base/cache_lines.h"
#include "model/timing/account.h"
#include "model/timing/clock.h"
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
    Cycle arrival = Never; // of the oldest item
};

// A stage whose unit was called in the cycle. What changed since it was called before follows: of
// its links - in, out, asked, answered - and of the passages between its steps.
struct StageSeen {
    std::uint64_t links = 0, passages = 0; // that changed: a bit each
    std::uint32_t stage = 0;
    Activity activity = Activity::Idle;
    // Of a stage that tells its steps the rest is not asked, but for request_waits.
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

// What is written one behind the other. Its memory stays. Where the next goes is a pointer: a count
// of items would be multiplied by their size each time, in every cycle.
template <class Item>
class Written {
public:
    Written() = default;
    Written(const Written&) = delete;
    Written& operator=(const Written&) = delete;

    // For so many more at the most; those that are written are then taken.
    Item* room(std::size_t items) {
        if (static_cast<std::size_t>(limit_ - end_) < items) [[unlikely]]
            grow(items);
        return end_;
    }
    void take_until(Item* end) { end_ = end; }
    void add(const Item& item) {
        *room(1) = item;
        ++end_;
    }

    const Item* begin() const { return items_.data(); }
    const Item* end() const { return end_; }
    void clear() { end_ = items_.data(); }

private:
    void grow(std::size_t items) {
        const auto kept = static_cast<std::size_t>(end_ - items_.data());
        items_.resize(2 * (kept + items));
        end_ = items_.data() + kept;
        limit_ = items_.data() + items_.size();
    }

    std::vector<Item> items_;
    Item* end_ = nullptr;
    Item* limit_ = nullptr; // of the room that there is
};

// One is written while another is read.
struct alignas(CacheLinePair) PipeLog {
    Written<CycleSeen> cycles;
    Written<AnswerSeen> answers;
    Written<StageSeen> stages;
    Written<LinkSeen> links;
    Written<Passage> passages;
    Written<TakenSeen> taken;

    void clear() {
        cycles.clear();
        answers.clear();
        stages.clear();
        links.clear();
        passages.clear();
        taken.clear();
    }
};

} // namespace ffgpu::timing
