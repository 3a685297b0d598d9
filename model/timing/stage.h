// Stage: a unit's place in the pipe, and the links by which work comes to it and leaves it. A unit
// with two ways through it has two stages, each with its links. Inside a stage there may be steps,
// with passages between them; where none are told, all that it does is one.

#pragma once

#include "model/timing/passage.h"
#include "model/timing/resource.h"

#include <cstdint>
#include <vector>

namespace ffgpu::timing {

class Link;
class Unit;

struct StagePassage {
    const Passage* passage;
    std::uint32_t places = 0;
    // Cycles from an item's coming to its going at the least; from then until another has its
    // place.
    std::uint32_t through = 1, back = 0;
    std::uint32_t through_work = 0, back_work = 0; // of these, what the resource takes
    const Link* answers = nullptr; // of the fills that its items wait for; null: for none
    bool works_first = false;      // The step behind it works before an item goes, not after.
    std::uint32_t units = 0;       // that begin with its items; 0: no fewer than places
};

// Takes from passages, or from the stage's links; gives to passages, or to its links.
struct Step {
    std::vector<std::size_t> from{}, to{}; // the stage's passages
    bool takes = false, gives = false;     // by the stage's links
    std::uint32_t width = 1;               // items that may pass in a cycle
    std::uint32_t free_width = 0;          // without the resource's limits; 0: the same
    std::uint32_t lookups_per_cycle = 0;   // 0: it looks nothing up, or counts it as work
    std::uint32_t free_cycles = 1;         // of work on an item that no parameter takes away
    bool asks = false;                     // the memory, for what it looks up
    bool stores = false;                   // What it gives is written to the memory.
    bool takes_when_done = false; // What it takes was there before, while parts of it came.
};

struct Stage {
    Resource resource;
    Unit* unit;
    std::uint32_t width = 1;      // items that may pass in a cycle
    std::uint32_t free_width = 1; // without the resource's limits; 0: any number in no time
    const Link* input = nullptr;  // null: all of the unit's
    const Link* output = nullptr;
    bool expands = false; // What comes from memory takes it cycles more before it is of use.
    std::vector<StagePassage> passages{};
    std::vector<Step> steps{}; // in the order in which the unit goes through them in a cycle
    bool is_answered = true;   // Of a unit with two stages the first takes the memory's answers.
};

// Those of a stage that work comes and leaves by, and of its unit those by which it asks the memory
// and is answered.
struct StageLinks {
    explicit StageLinks(const Stage& stage);

    std::vector<const Link*> in, out, asked, answered;
};

} // namespace ffgpu::timing
