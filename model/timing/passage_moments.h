// PassageMoments: a passage between two steps as it was told of: what comes and goes in the cycle
// that is looked at, what the steps at its ends did since they did something last, and the moments
// of its items.

#pragma once

#include "model/timing/fill_moments.h"
#include "model/timing/moments.h"
#include "model/timing/passage.h"
#include "model/timing/stage.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace ffgpu::timing {

struct PassageMoments {
    // `answers`: fills that its items wait for; null: for none.
    PassageMoments(const StagePassage& told, const FillMoments* answers)
        : through(static_cast<float>(told.through))
        , through_work(static_cast<float>(told.through_work))
        , back(static_cast<float>(told.back))
        , back_work(static_cast<float>(told.back_work))
        , places(told.places)
        , works_first(told.works_first)
        , fills(answers)
        , exits(told.places)
        , units(told.units)
        , cycles_(std::bit_ceil(std::size_t{told.places} + 1)) {}

    // As told (stage.h).
    const float through, through_work, back, back_work;
    const std::uint32_t places;
    const bool works_first;
    const FillMoments* const fills;
    // Items: before the cycle, and in it.
    std::uint64_t entered = 0, left = 0;
    std::uint32_t coming = 0, going = 0;
    std::uint64_t awaited = 0; // the last of the fills that those that left waited for
    // Since the steps at its ends did something last:
    std::uint32_t lookups = 0, worked = 0;
    std::uint32_t waited = 0; // items that did until another of their place was gone
    std::uint32_t behind = 0; // up to the last one that one of them waited for
    std::uint32_t begun = 0;  // units that began
    float begun_cycles = 0;   // with items of so many cycles, in the mean
    // When items came, and went.
    Moments entries{8}, exits;
    // What a unit began with: when, and the cycles that it takes.
    struct Begun {
        Moment at{};
        float cycles = 0;
        float free_at() const { return static_cast<float>(at.at) + cycles; }
    };
    std::vector<Begun> units; // the first that is free first

    // Counts of a passage are modulo 2^32.
    void see(const Passage& passage) {
        coming = passage.entered - static_cast<std::uint32_t>(entered);
        going = passage.left - static_cast<std::uint32_t>(left);
        lookups = passage.looked_up - counted_.looked_up;
        worked = passage.worked - counted_.worked;
        awaited = passage.awaited;
        behind = passage.behind;
        waited = passage.waited - counted_.waited;
        begun = passage.begun - counted_.begun;
        if (begun == 0) return;
        seen_begun_cycles_ = passage.begun_cycles;
        begun_cycles = static_cast<float>(passage.begun_cycles - counted_.begun_cycles) /
                       static_cast<float>(begun);
        has_cycles_ |= begun_cycles != 0;
    }
    void count_lookups() { counted_.looked_up += std::exchange(lookups, 0); }
    void count_work() { counted_.worked += std::exchange(worked, 0); }
    void count_waited() { counted_.waited += std::exchange(waited, 0); }
    // In this moment.
    void count_begun(const Moment& moment) {
        if (!units.empty()) {
            const std::size_t count = std::min<std::size_t>(begun, units.size());
            std::fill_n(units.begin(), count, Begun{moment, begun_cycles});
            std::ranges::sort(units, {}, &Begun::free_at);
        }
        counted_.begun += std::exchange(begun, 0);
        counted_.begun_cycles = seen_begun_cycles_;
        begun_cycles = 0;
    }
    // The cycle is over.
    void count_items() {
        entered += std::exchange(coming, 0);
        left += std::exchange(going, 0);
    }

    // Cycles that a unit takes for an item: of each its own, or of none.
    bool has_cycles() const { return has_cycles_; }
    float cycles_of(std::uint64_t item) const { return cycles_[item & (cycles_.size() - 1)]; }
    void set_cycles(std::uint64_t item) { cycles_[item & (cycles_.size() - 1)] = begun_cycles; }

private:
    Passage counted_{}; // looked_up, worked, waited, begun and begun_cycles
    std::uint32_t seen_begun_cycles_ = 0;
    std::vector<float> cycles_; // modulo its size
    bool has_cycles_ = false;
};

} // namespace ffgpu::timing
