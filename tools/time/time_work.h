// The machine in time from a work file: what `replay --timing` would have told, without drawing.

#pragma once

#include "tools/config/configuration.h"

#include <string>

namespace ffgpu::tools {

struct TimeOptions {
    std::string input;
    std::string output; // a folder; empty: none
    Configuration configuration;
    std::string totals = {}; // a file for the sums over all frames; empty: none
    bool measure_gains =
        false; // gains.csv, too; it takes as many times longer as there are resources
};

// Returns a summary for people. Ends behind a frame where an Interruption came: stats.json has
// those before, and neither totals nor gains are written. Throws InputError; what was finished
// before is written.
std::string time_work(const TimeOptions& options);

} // namespace ffgpu::tools
