// The table of a sweep: a row a trace and point, in the order of the traces and of the space.

#pragma once

#include "tools/sweep/machine_cost.h"
#include "tools/sweep/sweep_plan.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace ffgpu::tools {

struct SweepRow {
    const SweepTrace* trace = nullptr;
    const DesignPoint* point = nullptr;
    bool is_stuck = false; // The machine stood still; its figures mean nothing.
    std::uint64_t frames = 0, cycles = 0, memory_bytes = 0;
    double milliseconds = 0;
    std::uint64_t cost = 0;                             // 0: nothing is known of units
    std::map<std::string, std::uint64_t> counters = {}; // of the units in time, by name
    // Of its trace no other point takes fewer cycles and no more bytes, or cost.
    bool is_best_by_bytes = false, is_best_by_cost = false;
};

// Of the results that are there. Throws InputError for one that is no result.
std::vector<SweepRow> read_results(const SweepPlan& plan, const UnitCosts& units);

// results.csv, with every counter that any row has.
std::string table_text(const SweepPlan& plan, const std::vector<SweepRow>& rows);

} // namespace ffgpu::tools
