// Bottlenecks: what the machine waited for, in each cycle one resource, and what it would gain
// without each: the critical path, and how near to it the other paths are.
//
// Each stage of the pipe has a moment, that in which it last took or sent anything (moment.h). It
// depends on
//   - the one before, and the work of its own since then; not where it only takes, has done no work
//     meanwhile, and only gave before,
//   - the last one in which it took, where it takes, and in which it gave, where it gives: a
//     stage's way in and its way out are used side by side,
//   - the moment in which what it takes, or works on, was sent, and the way,
//   - the moment in which a place came free for what it sends,
//   - the memory's last answer, where it waited for the memory and is its unit's only stage,
//   - the last moment of the stages behind it, where it waited until they are done.
// What it waited for beyond all of these it waited for behind what it gave in the cycle before,
// which freed a place inside it, else behind the last of them.
// The moment that is last, at the end of a frame, is the frame's.

#pragma once

#include "model/base/check.h"
#include "model/base/ring.h"
#include "model/timing/memory_observer.h"
#include "model/timing/memory_statistics.h"
#include "model/timing/memory_waits.h"
#include "model/timing/moment.h"
#include "model/timing/moments.h"
#include "model/timing/resource.h"
#include "model/timing/unit.h"
#include "model/timing/wait_paths.h"

#include <array>
#include <deque>
#include <span>
#include <vector>

namespace ffgpu::timing {

// A unit's place in the pipe. A unit with two ways through it has two, each with its links.
struct Stage {
    Resource resource;
    Unit* unit;
    std::uint32_t width = 1;      // items that may pass in a cycle
    std::uint32_t free_width = 1; // without the resource's limits; 0: any number in no time
    const Link* input = nullptr;  // null: all of the unit's
    const Link* output = nullptr;
    // What else limits its work: counters, whose sum grows by so much in a cycle at the most.
    std::vector<const Counter*> lookups{};
    std::uint32_t lookups_per_cycle = 0;
};

class BottleneckStatistics : public NamedStatistics {
public:
    BottleneckStatistics();
    void waited(Resource resource, Cycle cycles) {
        *waited_[static_cast<std::size_t>(resource)] += cycles;
    }
    void gained(Resource resource, float cycles) {
        if (cycles > 0) *gained_[static_cast<std::size_t>(resource)] += static_cast<Cycle>(cycles);
    }

private:
    std::array<Counter*, Resources> waited_, gained_;
};

class Bottlenecks final : public MemoryObserver {
public:
    struct Parts {
        std::vector<Stage> stages; // in the order of the pipe
        // By the arbiter's ports; of a port that only writes null.
        std::vector<const Link*> requests, responses;
        Unit& arbiter;
        const Unit& drain; // waits for all that the memory is asked
        const MemoryConfig& memory;
        bool memory_is_ours;
    };

    Bottlenecks(const Clock& clock, Parts parts);

    // Looks from the first cycle on, where it is called. Links are connected.
    void attach();
    // At the end of each cycle in which a unit was due.
    void end_cycle();
    // What the furthest stage that did something in this cycle saved since the frame began.
    const Saved& saved() const { return saved_; }
    // A frame ended with this cycle: its path; empty where nobody looked.
    std::vector<WaitPaths::Run> end_frame();
    const BottleneckStatistics& statistics() const { return statistics_; }

    // MemoryObserver
    void sent(const MemoryRequest&, std::uint64_t) override {}
    void done(const MemoryRequest& request, std::uint64_t cycle) override;

private:
    // When a link's items were sent, and when they left a place to another.
    struct Way {
        const Link* link;
        bool of_stage = false;                // Its producer is one.
        bool to_stage = false;                // Its consumer is one.
        bool to_memory = false;               // Its items are answered to.
        std::uint64_t pushed = 0, popped = 0; // that were looked at
        Moments sent{8}, freed;
        // Requests whose answer has not come, from the oldest on.
        std::uint64_t first_asked = 0;
        Ring<std::uint8_t> answered{};

        // The first that is still of use.
        std::uint64_t first_sent() const {
            if (to_memory) return first_asked;
            return to_stage ? popped : link->popped();
        }
        void send(std::uint64_t item, const Moment& moment) {
            sent.make_room(first_sent(), item);
            sent[item] = moment;
        }
        void note_answer(std::uint64_t item);
        // When the place of the item came free; long ago where it is the first there.
        const Moment& place_freed(std::uint64_t item) const { return freed[item - link->places()]; }
    };
    // What went by in a cycle: items.
    struct Moved {
        std::uint64_t taken = 0, given = 0;
        bool refused = false;
    };
    struct Place {
        Stage stage;
        std::vector<Way*> in, out, asked, answered;
        Moment last;
        Moment* memory; // its unit's last answer
        Cycle looked = 0;
        Activity activity = Activity::Idle; // then
        bool had_backlog = false, was_refused = false;
        bool unit_was_refused = false; // by any of the unit's ways out
        std::uint64_t lookups = 0;
        // Cycles since its last moment: of its work that held up others, and of all of it.
        float work = 0, active = 0;
        Moment taken{}, given{};
        float busy = 0; // Since it took anything: all cycles of its work.
        bool on_memory = false, drains = false;
    };
    static constexpr std::size_t Most = 48; // dependences of a moment
    struct Dependences {
        std::array<Dependence, Most> all; // the first of them
        std::size_t count = 0;
        Dependence& add(const Dependence& one) {
            check(count < Most, "so many dependences at the most");
            return all[count++] = one;
        }
    };

    Way& way_of(const Link* link);
    void connect(Place& place);
    void look(Place& place);
    static void note_stall(Place& place, Activity activity, bool refused);
    void take_answers(Place& place);
    void count_work(Place& place, const Moved& moved);
    void act(Place& place, const Moved& moved);
    // All into found_.
    void find_dependences(const Place& place, const Moved& moved);
    void find_port(const Stage& stage, const Moment& before, std::uint64_t items);
    // Returns the one that was over last.
    const Dependence& explain(const Place& place, const Moved& moved);
    void pass_on(Place& place);
    void take_requests();
    void collect_paths();

    const Clock& clock_;
    const Parts parts_;
    BottleneckStatistics statistics_;
    WaitPaths paths_;
    MemoryWaits memory_;
    std::deque<Way> ways_;
    std::vector<Place> places_;
    std::deque<std::pair<const Unit*, Moment>> answers_; // the last of each unit
    std::vector<Way*> requests_, responses_;             // by the arbiter's ports
    std::vector<WaitPaths::Path*> heads_;                // of collect_paths()
    Dependences found_;
    std::uint64_t called_ = 0; // stages, a bit each, and the arbiter, whose units were called
    Saved saved_;
    Cycle frame_begin_ = 0; // The cycle before it.
    bool looks_ = false;    // Somebody attached it.
};

} // namespace ffgpu::timing
