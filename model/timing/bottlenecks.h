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
// The moment that is last, at the end of a frame, is the frame's. That one depends on all the work
// that each channel of the memory has had since the frame's begin, too.
//
// All that it reads of the machine is a log (pipe_watch.h); it changes nothing in it.

#pragma once

#include "model/base/check.h"
#include "model/base/ring.h"
#include "model/timing/fill_moments.h"
#include "model/timing/frame_waits.h"
#include "model/timing/link.h"
#include "model/timing/memory_waits.h"
#include "model/timing/moment.h"
#include "model/timing/moments.h"
#include "model/timing/passage_moments.h"
#include "model/timing/pipe_log.h"
#include "model/timing/pipe_watch.h"
#include "model/timing/resource.h"
#include "model/timing/wait_paths.h"

#include <array>
#include <deque>
#include <span>
#include <utility>
#include <vector>

namespace ffgpu::timing {

// Of a cycle, in sixteenths, whose sums are the same in any order.
inline float part(std::uint64_t items, std::uint32_t in_a_cycle) {
    if (items == 0 || in_a_cycle == 1) return static_cast<float>(static_cast<std::int64_t>(items));
    return static_cast<float>(16 * items / in_a_cycle) / 16;
}

class Bottlenecks {
public:
    // Links are connected. The machine's first frame begins.
    explicit Bottlenecks(const PipeParts& parts);

    // What was seen next.
    void reckon(const PipeLog& log);
    // A frame ended with this cycle.
    FrameWaits end_frame(Cycle now);

private:
    // When a link's items were sent, and when they left a place to another.
    struct Way {
        const Link* link; // which it is: the machine writes there meanwhile, and is not disturbed
        std::size_t places;
        Cycle latency;
        bool of_stage = false;  // Its producer is one.
        bool to_stage = false;  // Its consumer is one.
        bool to_memory = false; // Its items are answered to.
        // Items: as seen last, and that were looked at.
        std::uint64_t seen_pushed = 0, seen_popped = 0, pushed = 0, popped = 0;
        Cycle arrival = Never;
        Cycle sent_at = 0; // of the last, by stages with steps
        Moments sent{8}, freed;
        // Requests whose answer has not come, from the oldest on.
        std::uint64_t first_asked = 0;
        Ring<std::uint8_t> answered{};
        FillMoments* fills = nullptr; // that its items complete

        // The first that is still of use.
        std::uint64_t first_sent() const {
            if (to_memory) return first_asked;
            return to_stage ? popped : seen_popped;
        }
        void see(const LinkSeen& seen) {
            seen_pushed += static_cast<std::uint32_t>(seen.pushed - seen_pushed);
            seen_popped += static_cast<std::uint32_t>(seen.popped - seen_popped);
            arrival = seen.arrival;
        }
        std::uint64_t coming() const { return seen_pushed - pushed; }
        std::uint64_t going() const { return seen_popped - popped; }
        void send(std::uint64_t item, const Moment& moment) {
            sent.make_room(first_sent(), item);
            sent[item] = moment;
        }
        void note_answer(std::uint64_t item);
        // When the place of the item came free; long ago where it is the first there.
        const Moment& place_freed(std::uint64_t item) const { return freed[item - places]; }
    };
    struct Place;
    // What went by in a cycle: items.
    struct Moved {
        std::uint64_t taken = 0, given = 0, asked = 0;
        bool refused = false;
    };
    // What a unit has of the memory.
    struct AtMemory {
        const Unit* unit;
        Moment answer{}; // the last
        Moment asked{};  // of stages with steps
        // The steps' that did so last; null: none in this frame.
        const Moment* looked_up = nullptr;
        const Moment* stored = nullptr;
        const Place* looks_up = nullptr; // the stage of the first of them
    };
    // Of passages, a bit each: where something came, or went; and where the steps at their ends
    // looked something up, or worked, since they did something last.
    struct Changed {
        std::uint64_t came = 0, went = 0, looked_up = 0, worked = 0;
    };
    struct StepPlace;
    using Act = void (Bottlenecks::*)(Place&, StepPlace&, const Moved&);
    struct StepPlace {
        const Step& told;
        Act act = nullptr;                         // by the number of its passages
        std::vector<PassageMoments*> from{}, to{}; // its passages
        std::uint64_t from_bits = 0, to_bits = 0;  // and their bits
        bool expands = false;                      // what its items waited for
        Moment last{};
    };
    struct Place {
        const Stage& stage;
        std::vector<Way*> in, out, asked, answered;
        std::vector<Way*> ways{}; // all of these, in this order
        std::uint64_t in_bits = 0, out_bits = 0, asked_bits = 0, answered_bits = 0; // of them
        Moment last; // of one with steps: the frame's begin
        AtMemory* memory;
        const Moment* latest = nullptr; // the last, or a step's that stands for it
        std::vector<PassageMoments> passages{};
        std::vector<StepPlace> steps{};
        Changed changed{}; // of these passages
        Cycle looked = 0;
        Activity activity = Activity::Idle; // then
        bool had_backlog = false, was_refused = false;
        bool unit_was_refused = false; // by any of the unit's ways out
        bool request_waits = false;    // of its unit
        bool is_last = true;           // of its unit's
        bool gives_by_one = false;     // of its steps
        // Cycles since its last moment: of its work that held up others, and of all of it.
        float work = 0, active = 0;
        Moment taken{}, given{};
        float busy = 0; // Since it took anything: all cycles of its work.
        bool on_memory = false, drains = false;
    };
    // What is left to read of a log.
    struct Reader {
        const AnswerSeen* answers;
        const StageSeen* stages;
        const LinkSeen* links;
        const Passage* passages;
        const TakenSeen* taken;
    };

    Way& way_of(const Link* link);
    void connect(Place& place);
    void reckon(const CycleSeen& cycle, Reader& seen);
    void answer(const AnswerSeen& answer);
    static Moved see_links(const Place& place, const StageSeen& seen, Reader& log);
    void look(Place& place, const StageSeen& seen, const Moved& moved);
    void note_stall(Place& place, Activity activity, bool refused) const;
    void take_answers(Place& place);
    void count_work(Place& place, const StageSeen& seen, const Moved& moved);
    void act(Place& place, const Moved& moved);
    // All into found_.
    void find_dependences(const Place& place, const Moved& moved);
    void find_port(const Stage& stage, const Moment& before, std::uint64_t items);
    // Until one of them is all that was waited for.
    void explain(const Place& place, const Moved& moved);
    void pass_on(Place& place);
    static void send(const std::vector<Way*>& ways, const Moment& moment);
    // Of stages with steps:
    struct StepMoved {
        std::uint64_t taken = 0, given = 0, coming = 0, lookups = 0;
        float worked = 0;
    };
    void connect_steps(Place& place);
    static void see_passages(Place& place, std::uint64_t seen, Reader& log);
    void go_through_steps(Place& place, std::uint64_t links, const Moved& moved);
    static bool acts(const Place& place, const StepPlace& step, const Moved& moved, bool unit_asks);
    static Act act_of(const Step& step);
    // Of a step with so many passages before it and behind it: none, one, or any number.
    template <int From, int To>
    void act(Place& place, StepPlace& step, const Moved& all);
    template <int From, int To>
    static StepMoved moved_by(const Place& place, const StepPlace& step, const Moved& moved);
    template <int From, int To>
    void find_dependences(const Place& place, const StepPlace& step, const StepMoved& moved);
    void explain(const Place& place, const StepPlace& step);
    template <int From, int To>
    void pass_on(Place& place, const StepPlace& step, const StepMoved& moved);
    void note_look_up(const Place& place, const Moment& moment);
    void give(Place& place, const Moment& moment);
    void ask(Place& place);
    // Of what was found, which it may be one of.
    void move_on(Moment& moment, Resource resource) {
        const Dependence& last = found_.last_one();
        WaitPaths::Path path = paths_.extend(last.moment->path, last.first.resource, now_ - 1);
        path = paths_.extend(path, resource, now_);
        // First these, since the moment is copied whole as soon as all of it is known.
        moment.at = now_;
        moment.path = paths_.share(path);
        found_.save(moment.saved);
    }
    void take_requests(const TakenSeen& taken);
    void charge(Saved& entry);
    void collect_paths();

    const PipeParts& parts_;
    Cycle now_ = 0, frame_begin_ = 0;
    WaitPaths paths_;
    MemoryWaits memory_;
    std::deque<Way> ways_;
    std::vector<Place> places_;
    std::deque<AtMemory> at_memory_;
    std::deque<FillMoments> fills_;
    std::vector<Way*> requests_, responses_; // by the arbiter's ports
    std::vector<WaitPaths::Path*> heads_;    // of collect_paths()
    Dependences found_;
    // What the stage that did something last saved since the frame began, and what of it was
    // charged to somebody.
    const Saved* saved_;
    Saved charged_;
    std::vector<Saved> saved_by_;
};

} // namespace ffgpu::timing
