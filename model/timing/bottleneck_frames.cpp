// Bottlenecks: the end of a frame, and the paths that are of use until then.

#include "model/timing/bottlenecks.h"

#include <algorithm>
#include <utility>

namespace ffgpu::timing {

void Bottlenecks::collect_paths() {
    heads_.clear();
    for (Place& place : places_)
        heads_.insert(heads_.end(), {&place.last.path, &place.taken.path, &place.given.path});
    for (Way& way : ways_)
        for (Moments* const moments : {&way.sent, &way.freed})
            for (Moment& moment : *moments)
                heads_.push_back(&moment.path);
    for (AtMemory& each : at_memory_)
        heads_.insert(heads_.end(), {&each.answer.path, &each.asked.path});
    for (FillMoments& fills : fills_)
        fills.for_each_path([this](WaitPaths::Path& path) { heads_.push_back(&path); });
    for (Place& place : places_) {
        for (StepPlace& step : place.steps)
            heads_.push_back(&step.last.path);
        for (PassageMoments& each : place.passages) {
            for (Moments* const moments : {&each.entries, &each.exits})
                for (Moment& moment : *moments)
                    heads_.push_back(&moment.path);
            for (PassageMoments::Begun& unit : each.units)
                heads_.push_back(&unit.at.path);
        }
    }
    memory_.add_heads(heads_);
    paths_.collect(heads_);
}

FrameWaits Bottlenecks::end_frame(Cycle now) {
    const Place* last = &places_.front();
    for (const Place& place : places_)
        if (place.latest->at > last->latest->at) last = &place;
    const WaitPaths::Path path = paths_.extend(last->latest->path, Resource::Links, now);
    check(paths_.end(path) == now, "a frame's path goes from its begin to its end");
    // A channel of the memory serves all of a frame's requests in it, in any order.
    const Moment begin{frame_begin_, 0, {}};
    found_.begin(last->latest->at);
    found_.add({last->latest, 0});
    memory_.for_each_channel_work([&](float cycles) {
        found_.add({&begin, cycles, {Resource::MemoryBandwidth, cycles}});
    });
    Saved saved;
    found_.save(saved);
    saved_ = &saved;
    FrameWaits waits{
        .runs = paths_.runs(path), .saved = saved, .saved_by = std::exchange(saved_by_, {})};
    charge(waits.saved_at_end);
    saved_ = &places_.front().last.saved;
    frame_begin_ = now;
    charged_ = {};
    paths_.restart(now);
    for (Place& place : places_) {
        place.last = place.taken = place.given = {now, 0, {}};
        place.latest = &place.last;
    }
    for (Way& way : ways_)
        for (Moments* const moments : {&way.sent, &way.freed})
            std::fill(moments->begin(), moments->end(), Moment{});
    for (AtMemory& each : at_memory_)
        each.answer = each.asked = {}, each.looked_up = each.stored = nullptr;
    for (FillMoments& fills : fills_)
        fills.restart();
    for (Place& place : places_) {
        for (StepPlace& step : place.steps)
            step.last = place.last;
        for (PassageMoments& each : place.passages) {
            for (Moments* const moments : {&each.entries, &each.exits})
                std::fill(moments->begin(), moments->end(), Moment{});
            std::ranges::fill(each.units, PassageMoments::Begun{});
        }
    }
    memory_.restart();
    return waits;
}

} // namespace ffgpu::timing
