// Sweep: a design space over traces, as jobs that Snakemake runs; what is finished stays finished
// whatever is killed, and the same command goes on with the rest.

#pragma once

#include <string>
#include <vector>

namespace ffgpu::tools {

struct SweepOptions {
    std::string space;
    std::vector<std::string> traces; // or captures, or work files
    std::string output;              // a folder
    std::string frames;              // A-B; empty: all
    std::string profile;             // of Snakemake; empty: this machine
    unsigned cores = 0;              // of this machine; 0: all
    std::string version;             // of ffgpu
};

// Returns a summary for people. Throws InputError for what is wrong with the space, a trace, or a
// job; what was finished is kept, and in the table.
std::string sweep(const SweepOptions& options);

} // namespace ffgpu::tools
