#include "model/timing/bottlenecks.h"

#include "model/timing/link.h"

#include <algorithm>
#include <bit>
#include <string>
#include <utility>

namespace ffgpu::timing {

Bottlenecks::Bottlenecks(const PipeParts& parts)
    : parts_(parts)
    , memory_(parts.memory, parts.memory_is_ours) {
    for (const Stage& stage : parts.stages)
        places_.push_back({.stage = stage,
                           .in = {},
                           .out = {},
                           .asked = {},
                           .answered = {},
                           .last = {},
                           .memory = nullptr});
    for (Place& place : places_)
        connect(place);
    for (const Link* const link : parts.requests) {
        requests_.push_back(&way_of(link));
        requests_.back()->to_memory = requests_.back()->of_stage;
    }
    for (const Link* const link : parts.responses)
        responses_.push_back(link ? &way_of(link) : nullptr);
    const auto is_rare = [](const Stage& stage) { return timing::is_rare(stage.resource); };
    if (std::ranges::none_of(parts.stages, is_rare)) {
        found_.leave_out_rare();
        memory_.leave_out_rare();
    }
    paths_.restart(0);
    saved_ = &places_.front().last.saved;
}

Bottlenecks::Way& Bottlenecks::way_of(const Link* link) {
    for (Way& way : ways_)
        if (way.link == link) return way;
    const auto is_stage = [&](const Unit* unit) {
        return std::ranges::any_of(places_,
                                   [&](const Place& place) { return place.stage.unit == unit; });
    };
    const bool of_stage = is_stage(link->producer());
    return ways_.emplace_back(Way{.link = link,
                                  .places = link->places(),
                                  .latency = link->latency(),
                                  .of_stage = of_stage,
                                  .to_stage = is_stage(link->consumer()),
                                  .freed = Moments(of_stage ? link->places() : 1)});
}

void Bottlenecks::connect(Place& place) {
    const StageLinks links(place.stage);
    for (const auto& [from, to] : {std::pair{&links.in, &place.in},
                                   std::pair{&links.out, &place.out},
                                   std::pair{&links.asked, &place.asked},
                                   std::pair{&links.answered, &place.answered}})
        for (const Link* const link : *from)
            to->push_back(&way_of(link));
    for (const auto& [ways, bits] : {std::pair{&place.in, &place.in_bits},
                                     std::pair{&place.out, &place.out_bits},
                                     std::pair{&place.asked, &place.asked_bits},
                                     std::pair{&place.answered, &place.answered_bits}})
        for (Way* const way : *ways) {
            *bits |= std::uint64_t{1} << place.ways.size();
            place.ways.push_back(way);
        }
    const Unit* const unit = place.stage.unit;
    for (AtMemory& each : at_memory_)
        if (each.unit == unit) place.memory = &each;
    if (!place.memory) place.memory = &at_memory_.emplace_back(AtMemory{.unit = unit});
    place.latest = &place.last;
    check(8 + place.in.size() + place.out.size() + place.asked.size() <= Dependences::Most,
          "so many dependences at the most");
    connect_steps(place);
}

// --- Each cycle --------------------------------------------------------------------------------

void Bottlenecks::reckon(const PipeLog& log) {
    Reader seen{log.answers.begin(),
                log.stages.begin(),
                log.links.begin(),
                log.passages.begin(),
                log.taken.begin()};
    for (const CycleSeen& cycle : log.cycles)
        reckon(cycle, seen);
}

void Bottlenecks::reckon(const CycleSeen& cycle, Reader& seen) {
    now_ = cycle.now;
    for (std::uint32_t i = 0; i < cycle.answers; ++i)
        answer(*seen.answers++);
    for (std::uint32_t i = 0; i < cycle.stages; ++i) {
        const StageSeen& stage = *seen.stages++;
        Place& place = places_[stage.stage];
        const Moved moved = see_links(place, stage, seen);
        see_passages(place, stage.passages, seen);
        look(place, stage, moved);
    }
    for (std::uint32_t i = 0; i < cycle.taken; ++i)
        take_requests(*seen.taken++);
    if (cycle.charged != CommandLedger::Nobody) {
        if (cycle.charged >= saved_by_.size()) saved_by_.resize(cycle.charged + 1);
        charge(saved_by_[cycle.charged]);
    }
    if (paths_.is_full()) collect_paths();
}

// What was saved since the last charge.
void Bottlenecks::charge(Saved& entry) {
    for (std::size_t i = 0; i < Saved::Lanes; ++i)
        entry.cycles[i] += saved_->cycles[i] - charged_.cycles[i];
    charged_ = *saved_;
}

inline Bottlenecks::Moved
Bottlenecks::see_links(const Place& place, const StageSeen& seen, Reader& log) {
    Moved moved{.refused = seen.refused};
    for (std::uint64_t left = seen.links; left != 0; left &= left - 1) {
        const std::uint64_t bit = left & (~left + 1);
        Way& way = *place.ways[static_cast<std::size_t>(std::countr_zero(left))];
        way.see(*log.links++);
        if ((bit & place.in_bits) != 0)
            moved.taken += way.going();
        else if ((bit & place.out_bits) != 0)
            moved.given += way.coming();
        else if ((bit & place.asked_bits) != 0)
            moved.asked += way.coming();
    }
    return moved;
}

void Bottlenecks::look(Place& place, const StageSeen& seen, const Moved& moved) {
    if ((seen.links & place.answered_bits) != 0) take_answers(place);
    if (!place.steps.empty()) {
        if ((seen.links | seen.passages) != 0 || place.request_waits)
            go_through_steps(place, seen.links, moved);
        place.request_waits = seen.request_waits;
        return;
    }
    count_work(place, seen, moved);
    // The cycles in which its unit slept were as the last one.
    if (now_ > place.looked + 1) note_stall(place, place.activity, place.unit_was_refused);
    note_stall(place, seen.activity, seen.unit_refused);
    if (moved.taken + moved.given + moved.asked > 0) act(place, moved);
    place.activity = seen.activity;
    place.was_refused = seen.refused;
    place.unit_was_refused = seen.unit_refused;
    place.looked = now_;
    place.had_backlog = seen.has_backlog;
}

void Bottlenecks::note_stall(Place& place, Activity activity, bool refused) const {
    // Who waits for all that the memory does asks it for nothing meanwhile.
    const bool drains = place.stage.unit == &parts_.drain;
    place.on_memory |=
        activity == Activity::StalledMemory || (activity == Activity::StalledRequests && !drains);
    place.drains |= activity == Activity::StalledOutput && !refused;
}

void Bottlenecks::take_answers(Place& place) {
    for (Way* const way : place.answered) {
        for (; way->popped < way->seen_popped; ++way->popped) {
            Moment answer = way->sent[way->popped];
            const Cycle way_back = way->latency - 1;
            if (way_back > 0) { // of a second level of caches alone
                answer.at += way_back;
                answer.path =
                    paths_.share(paths_.extend(answer.path, Resource::TexelL2, answer.at));
                answer.saved[Resource::TexelL2] += static_cast<float>(way_back);
            }
            merge(paths_, place.memory->answer, answer);
            if (way->fills) way->fills->come(paths_, answer);
            way->freed[way->popped] = answer;
        }
    }
}

// A cycle in which it leaves work behind is all of it work, unless it is refused or could have gone
// on before.
void Bottlenecks::count_work(Place& place, const StageSeen& seen, const Moved& moved) {
    if (place.activity == Activity::Busy) {
        const auto gap = static_cast<float>(now_ - place.looked - 1);
        place.busy += gap;
        place.active += gap;
        if (place.had_backlog && !place.was_refused) place.work += gap;
    }
    if (seen.activity != Activity::Busy) return;
    ++place.active;
    const bool is_refused = moved.refused || place.was_refused;
    const bool moves = moved.taken > 0 || moved.given > 0;
    if (place.had_backlog && !is_refused) ++place.work;
    if (!is_refused || !moves) ++place.busy;
}

// The arbiter takes them.
void Bottlenecks::take_requests(const TakenSeen& taken) {
    Way& way = *requests_[taken.port];
    way.see(taken.link);
    for (; way.popped < way.seen_popped; ++way.popped) {
        const Moment& sent = way.sent[way.popped];
        way.freed[way.popped] =
            way.of_stage ? memory_.taken(paths_, sent, now_) : Moment{now_, sent.path, {}};
    }
}

// The answers come in any order.
void Bottlenecks::Way::note_answer(std::uint64_t item) {
    while (answered.size() <= item - first_asked)
        answered.push_back(0);
    answered[item - first_asked] = 1;
    for (; !answered.empty() && answered.front() != 0; ++first_asked)
        answered.pop_front();
}

void Bottlenecks::answer(const AnswerSeen& answer) {
    const MemoryRequest& request = answer.request;
    Way& way = *requests_[request.port];
    const Moment* const asked = way.of_stage ? &way.sent[request.number] : nullptr;
    const Moment& moment = memory_.answer(paths_, request, asked, now_);
    if (way.to_memory) way.note_answer(request.number);
    Way* const back = responses_[request.port];
    if (!back) return;
    back->see(answer.back);
    if (request.write) return;
    back->send(back->seen_pushed, moment);
    if (back->fills) back->fills->number_next(request.ticket);
}

// --- Moments -----------------------------------------------------------------------------------

// What is taken goes the way of what was taken before it, what is given that of what was given:
// side by side.
void Bottlenecks::find_port(const Stage& stage, const Moment& before, std::uint64_t items) {
    if (items == 0) return;
    const float takes = part(items, stage.width);
    const float free = stage.free_width > 0 ? part(items, stage.free_width) : 0;
    found_.add({&before, takes, {stage.resource, std::max(takes - free, 0.0F)}});
}

void Bottlenecks::find_dependences(const Place& place, const Moved& moved) {
    const Cycle now = now_;
    Dependences& found = found_;
    found.begin(now);
    const float work = place.work;
    // What is taken does not wait for what is given beside it.
    const bool beside = moved.given == 0 && moved.taken > 0 && place.taken.at < place.last.at &&
                        place.stage.free_width > 0 && work == 0;
    if (!beside) found.add({&place.last, work, {place.stage.resource, work}});
    find_port(place.stage, place.taken, moved.taken);
    find_port(place.stage, place.given, moved.given);
    for (const Way* const way : place.in) {
        // One that is taken when done is worked on before.
        const bool takes = way->popped != way->seen_popped;
        if (!takes && (way->arrival > now || way->arrival <= place.last.at)) continue;
        const Moment& sent = way->sent[takes ? way->seen_popped - 1 : way->popped];
        const Cycle arrival = sent.at + way->latency;
        // What came behind the last moment has been worked on since, where it is taken when done.
        const float since =
            arrival > place.last.at && arrival < now ? static_cast<float>(now - arrival) : 0;
        const float on_it = std::min(work, since);
        const auto latency = static_cast<float>(way->latency);
        found.add({&sent,
                   latency + on_it,
                   {Resource::Links, latency - 1},
                   {place.stage.resource, on_it}});
    }
    bool gives = false;
    for (const std::vector<Way*>* const ways : {&place.out, &place.asked}) {
        for (const Way* const way : *ways) {
            if (way->pushed == way->seen_pushed) continue;
            found.add({&way->place_freed(way->seen_pushed - 1), 1});
            gives = true;
        }
    }
    if (gives) found.add({&place.taken, place.busy, {place.stage.resource, place.busy}});
    if (place.on_memory)
        found.add({place.stage.unit == &parts_.drain ? &memory_.all() : &place.memory->answer, 1});
    if (place.drains) {
        const Place* last = nullptr;
        for (const Place& other : places_)
            if (&other > &place && (!last || other.latest->at >= last->latest->at)) last = &other;
        if (last && last->latest->at < now) found.add({last->latest, 1});
    }
}

// What none of them explains was waited for behind what the stage gave in the cycle before, where
// it takes, else behind the last of them, or behind an answer of the memory that came meanwhile: a
// unit that still does something else does not say that it waits for it.
void Bottlenecks::explain(const Place& place, const Moved& moved) {
    if (found_.least() == 0) return;
    if (place.stage.free_width == 0) { // It carries bytes between what it sends.
        const float carried = std::min(place.active, found_.slack_of(0));
        found_[0].first.cycles += carried;
        found_.lengthen(0, carried);
    }
    const float more = found_.least();
    if (more == 0) return;
    // Either is over later than all others.
    if (moved.taken > 0 && place.given.at + 1 == now_) { // A place inside it came free with that.
        found_.add({&place.given, 1});
        return;
    }
    const Dependence answer{&place.memory->answer, 1};
    if (slack(answer, now_) < more) found_.add(answer);
    const std::size_t last = found_.last();
    const float rest = found_.least();
    found_.lengthen(last, rest);
    if (place.stage.expands && place.on_memory) {
        Dependence::Part& then = found_[last].then;
        check(then.cycles == 0 || then.resource == place.stage.resource,
              "what comes behind the way is the stage's own");
        then = {place.stage.resource, then.cycles + rest};
    }
}

void Bottlenecks::act(Place& place, const Moved& moved) {
    find_dependences(place, moved);
    explain(place, moved);
    move_on(place.last, place.stage.resource);
    saved_ = &place.last.saved;
    if (moved.taken > 0) {
        place.taken = place.last;
        place.busy = 0;
    }
    if (moved.given > 0) place.given = place.last;
    pass_on(place);
    place.active = 0;
    place.work = 0;
    place.on_memory = place.drains = false;
}

void Bottlenecks::pass_on(Place& place) {
    for (Way* const way : place.in)
        for (; way->popped < way->seen_popped; ++way->popped)
            way->freed[way->popped] = place.last;
    for (const std::vector<Way*>* const ways : {&place.out, &place.asked})
        for (Way* const way : *ways)
            for (; way->pushed < way->seen_pushed; ++way->pushed)
                way->send(way->pushed, place.last);
}

} // namespace ffgpu::timing
