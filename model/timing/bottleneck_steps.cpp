// Bottlenecks: the moments of stages that tell of their steps, each with the items that it takes
// and gives.

#include "model/timing/bottlenecks.h"

#include <algorithm>
#include <array>
#include <bit>
#include <optional>
#include <utility>

namespace ffgpu::timing {

namespace {

// Of the passages before a step, or behind it.
constexpr int AnyNumber = -1;

template <int Count, class Each>
[[gnu::always_inline]] inline void for_each(const auto& passages, const Each& each) {
    if constexpr (Count == 1)
        each(*passages.front());
    else if constexpr (Count == AnyNumber)
        for (auto* const passage : passages)
            each(*passage);
}

// Of a step with so many passages before it, and behind it.
template <int From>
bool takes(const Step& step) {
    return From == AnyNumber ? step.takes : From == 0;
}
template <int To>
bool gives(const Step& step) {
    return To == AnyNumber ? step.gives : To == 0;
}

} // namespace

void Bottlenecks::connect_steps(Place& place) {
    place.is_last =
        std::none_of(places_.begin() + (&place - places_.data()) + 1,
                     places_.end(),
                     [&](const Place& other) { return other.stage.unit == place.stage.unit; });
    place.passages.reserve(place.stage.passages.size());
    for (const StagePassage& told : place.stage.passages) {
        FillMoments* fills = nullptr;
        if (told.answers) {
            Way& way = way_of(told.answers);
            if (!way.fills) way.fills = &fills_.emplace_back(way.places);
            fills = way.fills;
        }
        place.passages.emplace_back(told, fills);
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
        each.act = act_of(step);
        // Each passage before it has an item and its fill, each behind it a unit and two places.
        check(2 + 2 * step.from.size() + 3 * step.to.size() + place.in.size() + place.out.size() <=
                  Dependences::Most,
              "so many dependences at the most");
    }
    place.gives_by_one = std::ranges::count_if(place.stage.steps, &Step::gives) == 1;
}

// What comes from no passage comes by the links, what goes to none leaves by them.
Bottlenecks::Act Bottlenecks::act_of(const Step& step) {
    const std::size_t from = step.from.size(), to = step.to.size();
    if (step.takes && !step.gives && from == 0 && to == 1) return &Bottlenecks::act<0, 1>;
    if (!step.takes && step.gives && from == 1 && to == 0) return &Bottlenecks::act<1, 0>;
    if (!step.takes && !step.gives && from == 1 && to == 1) return &Bottlenecks::act<1, 1>;
    return &Bottlenecks::act<AnyNumber, AnyNumber>;
}

void Bottlenecks::see_passages(Place& place, std::uint64_t seen, Reader& log) {
    Changed& changed = place.changed;
    for (std::uint64_t left = seen; left != 0; left &= left - 1) {
        const std::uint64_t bit = left & (~left + 1);
        PassageMoments& each = place.passages[static_cast<std::size_t>(std::countr_zero(left))];
        each.see(*log.passages++);
        if (each.coming != 0) changed.came |= bit;
        if (each.going != 0) changed.went |= bit;
        if (each.lookups != 0) changed.looked_up |= bit;
        if (each.worked != 0) changed.worked |= bit;
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

template <int From, int To>
inline Bottlenecks::StepMoved
Bottlenecks::moved_by(const Place& place, const StepPlace& step, const Moved& moved) {
    StepMoved by{.taken = takes<From>(step.told) ? moved.taken : 0};
    for_each<From>(step.from, [&](const PassageMoments& each) {
        by.taken += each.going;
        by.worked += static_cast<float>(each.worked);
    });
    for_each<To>(step.to, [&](const PassageMoments& each) {
        by.coming += each.coming;
        by.lookups += each.lookups;
    });
    if (gives<To>(step.told))
        by.given = place.gives_by_one ? moved.given : std::min(moved.given, by.taken);
    return by;
}

// Inlined, as pass_on(): each has one caller, which calls it for each step of each quad.
template <int From, int To>
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
    if (timing::takes<From>(step.told)) {
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
    const bool gives_on = gives<To>(step.told) && moved.given > 0 && step.from.size() == 1;
    for_each<From>(step.from, [&](const PassageMoments& each) {
        if (each.going == 0 && !gives_on) return;
        // One that gives several things goes with the last of them.
        const std::uint64_t last = each.left + std::max(each.going, 1u) - 1;
        const float before = each.works_first ? std::max(moved.worked - 1, 0.0F) : 0;
        const Dependence::Part saved{
            resource, each.works_first ? moved.worked - std::min(moved.worked, kept) : 0};
        const float begun = each.has_cycles() ? std::max(each.cycles_of(last) - 1, 0.0F) : 0;
        found_.add({&each.entries[last],
                    each.through + before + begun,
                    {resource, saved.cycles + begun + each.through_work}});
        const Moment* const fill = each.fills ? each.fills->find(each.awaited) : nullptr;
        if (fill) found_.add({fill, 1 + before, saved});
    });
    for_each<To>(step.to, [&](const PassageMoments& each) {
        if (each.begun != 0 && !each.units.empty()) {
            const std::size_t begun = std::min<std::size_t>(each.begun, each.units.size());
            const PassageMoments::Begun& unit = each.units[begun - 1];
            found_.add({&unit.at, unit.cycles, {resource, unit.cycles}});
        }
        if (each.coming == 0) return;
        const std::uint64_t entered = each.entered + each.coming;
        if (each.waited) {
            const std::uint32_t since = static_cast<std::uint32_t>(entered) - each.behind;
            found_.add({&each.exits[entered - since - 1], each.back, {resource, each.back_work}});
        }
        if (entered <= each.places) return;
        found_.add({&each.exits[entered - 1 - each.places], each.back, {resource, each.back_work}});
    });
    if (!gives<To>(step.told) || moved.given == 0) return;
    for (const Way* const way : place.out)
        if (way->pushed != way->seen_pushed)
            found_.add({&way->place_freed(way->seen_pushed - 1), 1});
}

// What none of them explains was waited for behind what the unit did, or was answered, last.
void Bottlenecks::explain(const Place& place, const StepPlace& step) {
    const float more = found_.least();
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

template <int From, int To>
[[gnu::always_inline]] inline void
Bottlenecks::pass_on(Place& place, const StepPlace& step, const StepMoved& moved) {
    place.changed.worked &= ~step.from_bits;
    place.changed.looked_up &= ~step.to_bits;
    for_each<From>(step.from, [&](PassageMoments& each) {
        each.count_work();
        for (std::uint32_t item = 0; item < each.going; ++item)
            each.exits[each.left + item] = step.last;
    });
    for_each<To>(step.to, [&](PassageMoments& each) {
        each.count_lookups();
        for (std::uint64_t item = each.entered; item < each.entered + each.coming; ++item) {
            each.entries.make_room(each.left, item);
            each.entries[item] = step.last;
            if (each.has_cycles()) each.set_cycles(item);
        }
        if (each.waited) each.count_waited();
        if (each.begun != 0) each.count_begun(step.last);
    });
    if (step.told.asks) note_look_up(place, step.last);
    if (step.told.stores) place.memory->stored = &step.last;
    if (takes<From>(step.told))
        for (Way* const way : place.in)
            for (std::uint64_t item = way->popped; item < way->seen_popped; ++item)
                way->freed[item] = step.last;
    if (gives<To>(step.told) && moved.given != 0) give(place, step.last);
}

// Several may give in a cycle: what comes next takes all of it.
[[gnu::always_inline]] inline void Bottlenecks::give(Place& place, const Moment& moment) {
    std::optional<Moment> merged;
    const Moment* given = &moment;
    for (Way* const way : place.out) {
        if (way->pushed == way->seen_pushed) continue;
        if (way->sent_at == now_) [[unlikely]] {
            merged = *given;
            merge(paths_, *merged, way->sent[way->pushed]);
            given = &*merged;
        }
        way->sent_at = now_;
        for (std::uint64_t item = way->pushed; item < way->seen_pushed; ++item)
            way->send(item, *given);
    }
}

template <int From, int To>
void Bottlenecks::act(Place& place, StepPlace& step, const Moved& all) {
    const StepMoved moved = moved_by<From, To>(place, step, all);
    find_dependences<From, To>(place, step, moved);
    if (found_.least() != 0) explain(place, step);
    move_on(step.last, place.stage.resource);
    // The furthest of them stands for the stage.
    if (place.latest->at < now_ || !takes<From>(step.told)) place.latest = &step.last;
    saved_ = &place.latest->saved;
    pass_on<From, To>(place, step, moved);
}

// A way through them in which the unit goes, so that what it does behind something in the same
// cycle finds it.
void Bottlenecks::go_through_steps(Place& place, std::uint64_t links, const Moved& moved) {
    const bool asks = moved.asked > 0;
    // A request that has waited for a place goes before anything is looked up.
    if (asks && place.request_waits) ask(place);
    for (StepPlace& step : place.steps)
        if (acts(place, step, moved, asks)) (this->*step.act)(place, step, moved);
    for (std::uint64_t left = place.changed.came | place.changed.went; left != 0; left &= left - 1)
        place.passages[static_cast<std::size_t>(std::countr_zero(left))].count_items();
    place.changed.came = place.changed.went = 0;
    if ((links & place.out_bits) != 0)
        for (Way* const way : place.out)
            way->pushed = way->seen_pushed;
    if ((links & place.in_bits) != 0)
        for (Way* const way : place.in)
            way->popped = way->seen_popped;
    if (asks && place.is_last) ask(place);
}

// Of two stages of a unit that look up in one cycle the first asks: what it looks up is mostly new,
// what the second does has come for the first.
inline void Bottlenecks::note_look_up(const Place& place, const Moment& moment) {
    AtMemory& memory = *place.memory;
    const bool other_did =
        memory.looked_up && memory.looked_up->at == now_ && memory.looks_up != &place;
    if (other_did) return;
    memory.looked_up = &moment;
    memory.looks_up = &place;
}

// In the order in which it looked up what it asks for. Where nothing was looked up in the cycle, or
// stored, that was before.
void Bottlenecks::ask(Place& place) {
    AtMemory& memory = *place.memory;
    const std::array reasons{memory.looked_up, memory.stored};
    const bool is_new = std::ranges::any_of(
        reasons, [this](const Moment* reason) { return reason && reason->at == now_; });
    for (Way* const way : place.asked) {
        if (way->pushed == way->seen_pushed) continue;
        found_.begin(now_);
        found_.add({&memory.asked, 0});
        for (const Moment* const reason : reasons)
            if (reason && (is_new ? reason->at == now_ : memory.asked.at < reason->at))
                found_.add({reason, 0});
        found_.add({&way->place_freed(way->seen_pushed - 1), 1});
        move_on(memory.asked, place.stage.resource);
        for (; way->pushed < way->seen_pushed; ++way->pushed)
            way->send(way->pushed, memory.asked);
    }
}

} // namespace ffgpu::timing
