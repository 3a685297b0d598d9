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

constexpr std::uint32_t LargestRequest = 512; // bytes: the longest line of a cache

// How long a memory may keep a request waiting, at most: as many rows as a channel holds requests
// in its queue and before it, each with a refresh before it, for which the bus may stand as long
// again.
Cycle longest_wait(const MemoryConfig& memory) {
    const Cycle row =
        memory.precharge_cycles + memory.row_to_column_cycles + memory.row_active_cycles +
        memory.column_cycles + memory.burst_cycles + memory.column_to_column_cycles +
        memory.write_recovery_cycles + memory.write_to_read_cycles + memory.read_to_write_cycles +
        memory.activate_to_activate_cycles + memory.four_activates_cycles + memory.refresh_cycles;
    const Cycle bursts = memory.bursts(LargestRequest);
    const Cycle requests = 2 * Cycle{memory.queue} + memory.latency + 2;
    return 2 * requests * row * bursts * memory.core_clocks / memory.memory_clocks;
}

// A machine in whose pipe no unit has worked for a million cycles, or for longer than its memory
// may take, is wired wrongly, or has a memory that does not answer.
void Machine::check_progress() {
    const Cycle interval = std::max<Cycle>(1'000'000, longest_wait(config.memory));
    Cycle busy = 0;
    for (Unit* const unit : units())
        unit->settle();
    for (const Unit* const unit : stuck_parts().pipe)
        busy += unit->account().cycles(Activity::Busy);
    is_stuck = busy == busy_at_last_check && clock.now() != 0;
    busy_at_last_check = busy;
    next_progress_check = clock.now() + interval;
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
