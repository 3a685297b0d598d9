// Bottlenecks: the moments of stages that tell of their steps, each with the items that it takes
// and gives.

#include "model/timing/bottlenecks.h"

#include <algorithm>
#include <bit>
#include <optional>
#include <utility>

namespace ffgpu::timing {

void Bottlenecks::connect_steps(Place& place) {
    place.is_last =
        std::none_of(places_.begin() + (&place - places_.data()) + 1,
                     places_.end(),
                     [&](const Place& other) { return other.stage.unit == place.stage.unit; });
    for (const StagePassage& told : place.stage.passages) {
        Inner& each = place.passages.emplace_back(
            Inner{.told = told,
                  .exits = Moments(told.places),
                  .units = std::vector<Inner::Begun>(told.units),
                  .cycles = std::vector<float>(std::bit_ceil(std::size_t{told.places} + 1))});
        if (!told.answers) continue;
        Way& way = way_of(told.answers);
        if (!way.fills) way.fills = &fills_.emplace_back(way.places);
        each.fills = way.fills;
    }
    check(place.passages.size() <= 64, "a bit for each passage");
    for (const Step& step : place.stage.steps) {
        StepPlace& each = place.steps.emplace_back(StepPlace{.told = step});
        for (const std::size_t i : step.from) {
            each.from.push_back(&place.passages[i]);
            each.from_bits |= std::uint64_t{1} << i;
            each.expands |= place.stage.expands && place.passages[i].fills != nullptr;
        }
        for (const std::size_t i : step.to) {
            each.to.push_back(&place.passages[i]);
            each.to_bits |= std::uint64_t{1} << i;
        }
    }
    place.gives_by_one = std::ranges::count_if(place.stage.steps, &Step::gives) == 1;
}

void Bottlenecks::see_passages(Place& place, std::uint64_t seen, Reader& log) {
    Changed& changed = place.changed;
    for (std::uint64_t left = seen; left != 0; left &= left - 1) {
        const std::uint64_t bit = left & (~left + 1);
        Inner& each = place.passages[static_cast<std::size_t>(std::countr_zero(left))];
        each.seen = *log.passages++;
        if (each.coming() != 0) changed.came |= bit;
        if (each.going() != 0) changed.went |= bit;
        if (each.seen.looked_up != each.counted.looked_up) changed.looked_up |= bit;
        if (each.seen.worked != each.counted.worked) changed.worked |= bit;
    }
}

inline bool
Bottlenecks::acts(const Place& place, const StepPlace& step, const Moved& moved, bool unit_asks) {
    const Changed& changed = place.changed;
    const bool moves = (changed.went & step.from_bits) != 0 ||
                       ((changed.came | changed.looked_up) & step.to_bits) != 0;
    return moves || (step.told.takes && moved.taken > 0) ||
           (step.told.gives && place.gives_by_one && moved.given > 0) ||
           (step.told.asks && unit_asks && (changed.worked & step.from_bits) != 0);
}

inline Bottlenecks::StepMoved
Bottlenecks::moved_by(const Place& place, const StepPlace& step, const Moved& moved) {
    StepMoved by{.taken = step.told.takes ? moved.taken : 0};
    for (const Inner* const each : step.from) {
        by.taken += each->going();
        by.worked += static_cast<float>(each->seen.worked - each->counted.worked);
    }
    for (const Inner* const each : step.to) {
        by.coming += each->coming();
        by.lookups += each->seen.looked_up - each->counted.looked_up;
    }
    if (step.told.gives)
        by.given = place.gives_by_one ? moved.given : std::min(moved.given, by.taken);
    return by;
}

// Inlined, as pass_on(): each has one caller, which calls it for each step of each quad.
[[gnu::always_inline]] inline void
Bottlenecks::find_dependences(const Place& place, const StepPlace& step, const StepMoved& moved) {
    found_.begin(now_);
    const Resource resource = place.stage.resource;
    const auto taken = static_cast<float>(moved.taken);
    const std::uint64_t items = std::max(moved.taken, moved.given);
    const float passing = part(items, step.told.width);
    const float free = step.told.free_width > 0 ? part(items, step.told.free_width) : passing;
    const float looked_up =
        step.told.lookups_per_cycle > 0 ? part(moved.lookups, step.told.lookups_per_cycle) : 0;
    const float work = std::max(looked_up, moved.worked);
    const float kept =
        std::max(free, std::min(moved.worked, taken * static_cast<float>(step.told.free_cycles)));
    const float takes = std::max(passing, work);
    found_.add({&step.last, takes, {resource, takes - kept}});
    if (step.told.takes) {
        for (const Way* const way : place.in) {
            const bool takes_from = way->popped != way->seen_popped;
            // What it looks up, or takes parts of, before it takes it.
            const bool begins =
                moved.lookups > 0 || (moved.coming > 0 && step.told.takes_when_done);
            if (!takes_from && (!begins || way->arrival > now_)) continue;
            const Moment& sent = way->sent[takes_from ? way->seen_popped - 1 : way->popped];
            const auto latency = static_cast<float>(way->latency);
            found_.add({&sent, latency, {Resource::Links, latency - 1}});
        }
    }
    const bool gives_on = moved.given > 0 && step.from.size() == 1;
    for (const Inner* const from : step.from) {
        const Inner& each = *from;
        if (each.going() == 0 && !gives_on) continue;
        // One that gives several things goes with the last of them.
        const std::uint64_t last = each.left + std::max(each.going(), 1u) - 1;
        const float before = each.told.works_first ? std::max(moved.worked - 1, 0.0F) : 0;
        const Dependence::Part saved{
            resource, each.told.works_first ? moved.worked - std::min(moved.worked, kept) : 0};
        const float begun = std::max(each.cycles_of(last) - 1, 0.0F);
        found_.add({&each.entries[last],
                    static_cast<float>(each.told.through) + before + begun,
                    {resource, saved.cycles + begun + static_cast<float>(each.told.through_work)}});
        const Moment* const fill = each.fills ? each.fills->find(each.seen.awaited) : nullptr;
        if (fill) found_.add({fill, 1 + before, saved});
    }
    for (const Inner* const to : step.to) {
        const Inner& each = *to;
        if (each.begun() != 0 && !each.units.empty()) {
            const std::size_t begun = std::min<std::size_t>(each.begun(), each.units.size());
            const Inner::Begun& unit = each.units[begun - 1];
            found_.add({&unit.at, unit.cycles, {resource, unit.cycles}});
        }
        const std::uint64_t entered = each.entered + each.coming();
        if (each.coming() > 0 && each.seen.waited != each.counted.waited) {
            const std::uint32_t since = static_cast<std::uint32_t>(entered) - each.seen.behind;
            found_.add({&each.exits[entered - since - 1],
                        static_cast<float>(each.told.back),
                        {resource, static_cast<float>(each.told.back_work)}});
        }
        if (each.coming() == 0 || entered <= each.told.places) continue;
        found_.add({&each.exits[entered - 1 - each.told.places],
                    static_cast<float>(each.told.back),
                    {resource, static_cast<float>(each.told.back_work)}});
    }
    if (moved.given == 0) return;
    for (const Way* const way : place.out)
        if (way->pushed != way->seen_pushed)
            found_.add({&way->place_freed(way->seen_pushed - 1), 1});
}

// What none of them explains was waited for behind what the unit did, or was answered, last.
void Bottlenecks::explain(const Place& place, const StepPlace& step) {
    const float more = found_.least();
    if (more == 0) return;
    const auto give_all_to = [&](std::size_t last) {
        found_[last].then = {place.stage.resource, found_.least()};
        found_.lengthen(last, found_.least());
    };
    if (step.expands && found_.last_one().then.cycles == 0) // What has come becomes of use.
        return give_all_to(found_.last());
    Dependence other{&place.memory->answer, 1};
    float least = slack(other, now_);
    if (step.told.asks && place.memory->asked.at == now_) { // What it looked up found a place.
        other = {&place.memory->asked, 0};
        least = 0;
    }
    const auto look_at = [&](const Moment& moment) {
        const Dependence by{&moment, moment.at < now_ ? 1.0F : 0.0F};
        if (slack(by, now_) >= least) return;
        other = by;
        least = slack(by, now_);
    };
    if (step.told.asks) look_at(place.memory->asked);
    for (const Place& each : places_) {
        if (each.stage.unit != place.stage.unit) continue;
        for (const StepPlace& one : each.steps)
            if (&one != &step) look_at(one.last);
    }
    if (least < more) found_.add(other);
    const std::size_t last = found_.last();
    if (place.stage.expands && !step.from.empty() && found_[last].then.cycles == 0)
        return give_all_to(last);
    found_.lengthen(last, found_.least());
}

[[gnu::always_inline]] inline void
Bottlenecks::pass_on(Place& place, const StepPlace& step, const StepMoved& moved) {
    place.changed.worked &= ~step.from_bits;
    place.changed.looked_up &= ~step.to_bits;
    for (Inner* const from : step.from) {
        Inner& each = *from;
        each.counted.worked = each.seen.worked;
        for (std::uint32_t item = 0; item < each.going(); ++item)
            each.exits[each.left + item] = step.last;
    }
    for (Inner* const to : step.to) {
        Inner& each = *to;
        each.counted.looked_up = each.seen.looked_up;
        for (std::uint32_t item = 0; item < each.coming(); ++item) {
            each.entries.make_room(each.left, each.entered + item);
            each.entries[each.entered + item] = step.last;
            each.cycles_of(each.entered + item) = each.begun_cycles();
        }
        each.counted.waited = each.seen.waited;
        if (each.begun() != 0) {
            const std::size_t begun = std::min<std::size_t>(each.begun(), each.units.size());
            std::fill_n(each.units.begin(), begun, Inner::Begun{step.last, each.begun_cycles()});
            std::ranges::sort(each.units, {}, &Inner::Begun::free_at);
        }
        each.counted.begun = each.seen.begun;
        each.counted.begun_cycles = each.seen.begun_cycles;
    }
    if (step.told.asks) place.memory->looked_up = &step.last;
    if (step.told.stores) place.memory->stored = &step.last;
    if (step.told.takes)
        for (Way* const way : place.in)
            for (std::uint64_t item = way->popped; item < way->seen_popped; ++item)
                way->freed[item] = step.last;
    if (moved.given == 0) return;
    // Several may give in a cycle: what comes next takes all of it.
    std::optional<Moment> merged;
    const Moment* given = &step.last;
    for (Way* const way : place.out) {
        if (way->pushed == way->seen_pushed) continue;
        if (way->sent_at == now_) {
            merged = *given;
            merge(paths_, *merged, way->sent[way->pushed]);
            given = &*merged;
        }
        way->sent_at = now_;
        for (std::uint64_t item = way->pushed; item < way->seen_pushed; ++item)
            way->send(item, *given);
    }
}

void Bottlenecks::act(Place& place, StepPlace& step, const StepMoved& moved) {
    find_dependences(place, step, moved);
    explain(place, step);
    move_on(step.last, place.stage.resource);
    // The furthest of them stands for the stage.
    if (place.latest->at < now_ || !step.told.takes) place.latest = &step.last;
    saved_ = &place.latest->saved;
    pass_on(place, step, moved);
}

// A way through them in which the unit goes, so that what it does behind something in the same
// cycle finds it.
void Bottlenecks::go_through_steps(Place& place, const Moved& moved) {
    const bool asks = std::ranges::any_of(
        place.asked, [](const Way* way) { return way->pushed != way->seen_pushed; });
    // A request that has waited for a place goes before anything is looked up.
    if (asks && place.request_waits) ask(place);
    for (StepPlace& step : place.steps)
        if (acts(place, step, moved, asks)) act(place, step, moved_by(place, step, moved));
    for (std::uint64_t left = place.changed.came | place.changed.went; left != 0;
         left &= left - 1) {
        Inner& each = place.passages[static_cast<std::size_t>(std::countr_zero(left))];
        each.entered += each.coming();
        each.left += each.going();
        each.counted.entered = each.seen.entered;
        each.counted.left = each.seen.left;
    }
    place.changed.came = place.changed.went = 0;
    for (Way* const way : place.out)
        way->pushed = way->seen_pushed;
    for (Way* const way : place.in)
        way->popped = way->seen_popped;
    if (asks && place.is_last) ask(place);
}

// In the order in which it looked up what it asks for; what waited for its turn was looked up
// before.
void Bottlenecks::ask(Place& place) {
    AtMemory& memory = *place.memory;
    for (Way* const way : place.asked) {
        if (way->pushed == way->seen_pushed) continue;
        found_.begin(now_);
        found_.add({&memory.asked, 0});
        for (const Moment* const reason : {memory.looked_up, memory.stored})
            if (reason && (reason->at == now_ || memory.asked.at < reason->at))
                found_.add({reason, 0});
        found_.add({&way->place_freed(way->seen_pushed - 1), 1});
        move_on(memory.asked, place.stage.resource);
        for (; way->pushed < way->seen_pushed; ++way->pushed)
            way->send(way->pushed, memory.asked);
    }
}

} // namespace ffgpu::timing
