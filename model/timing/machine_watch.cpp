// The watchdog: finds that the machine goes on no more, and tells what it is at.

#include "model/timing/machine.h"

#include <algorithm>

#include <fmt/format.h>

namespace ffgpu::timing {

// The memory and its arbiter serve the units, and the screen, which never stops.
StuckParts Machine::stuck_parts() {
    StuckParts parts{.pipe = {}, .others = {&arbiter, &scan_out}, .outside = "memory"};
    if (const Unit* const second_level = texel_caches.unit())
        parts.others.insert(parts.others.begin(), second_level);
    if (const Unit* const unit = memory->unit()) parts.others.push_back(unit);
    for (const Unit* const unit : units())
        if (std::find(parts.others.begin(), parts.others.end(), unit) == parts.others.end())
            parts.pipe.push_back(unit);
    return parts;
}

// A machine in whose pipe no unit has worked for a million cycles is wired wrongly, or has a memory
// that does not answer.
void Machine::check_progress() {
    constexpr Cycle Interval = 1'000'000;
    Cycle busy = 0;
    for (Unit* const unit : units())
        unit->settle();
    for (const Unit* const unit : stuck_parts().pipe)
        busy += unit->account().cycles(Activity::Busy);
    is_stuck = busy == busy_at_last_check && clock.now() != 0;
    busy_at_last_check = busy;
    next_progress_check = clock.now() + Interval;
}

std::string Machine::stuck_report() {
    return fmt::format(
               "the timed machine is stuck in cycle {}; under way are {} draws and quads in "
               "the pipe, {} requests, {} of the screen\n",
               clock.now(),
               in_flight.count(),
               memory_in_flight.count(),
               screen_in_flight.count()) +
           describe_stuck(stuck_parts());
}

} // namespace ffgpu::timing
