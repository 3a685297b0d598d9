// What is told of a machine that goes on no more: who keeps the others waiting, and what each unit
// and its queues hold.
//
// Units wait for each other along links: one that is refused a place waits for the link's consumer,
// one that waits for data for whoever answers its requests. From the last unit of the pipe that has
// anything left, these waits are followed to their end: a unit that waits for nobody, somebody
// outside the machine's units, or units that wait in a circle.

#pragma once

#include "model/timing/unit.h"

#include <string>
#include <vector>

namespace ffgpu::timing {

struct StuckParts {
    std::vector<const Unit*> pipe;   // in the order of the pipe
    std::vector<const Unit*> others; // that serve it
    std::string outside;             // who is asked outside of the units
};

// Who keeps the others waiting, and how the waits lead there.
struct Culprit {
    std::vector<std::string> names; // one; of a circle all; none: nobody holds anything
    std::vector<std::string> waits; // "depth waits for arbiter" ...
};
Culprit find_culprit(const StuckParts& parts);

// Of the culprit and all units.
std::string describe_stuck(const StuckParts& parts);

} // namespace ffgpu::timing
