// Stage: a unit's place in the pipe, and the links by which work comes to it and leaves it. A unit
// with two ways through it has two stages, each with its links.

#pragma once

#include "model/base/statistics.h"
#include "model/timing/resource.h"

#include <cstdint>
#include <vector>

namespace ffgpu::timing {

class Link;
class Unit;

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
    bool expands = false; // What comes from memory takes it cycles more before it is of use.
};

// Those of a stage that work comes and leaves by, and of its unit those by which it asks the memory
// and is answered.
struct StageLinks {
    explicit StageLinks(const Stage& stage);

    std::vector<const Link*> in, out, asked, answered;
};

} // namespace ffgpu::timing
