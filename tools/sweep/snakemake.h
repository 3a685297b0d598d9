// Runs Snakemake on the flow of a sweep and listens to what goes wrong in its jobs.

#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace ffgpu::tools {

struct FlowOptions {
    std::filesystem::path folder; // of the sweep
    std::string profile;          // "slurm", or one that Snakemake finds; empty: on this machine
    unsigned cores = 0;           // of this machine; 0: all
    std::size_t jobs = 0;         // that are missing, for the progress line
};

// Where the rules and the profiles lie, in an installation or in the build tree.
std::filesystem::path find_flow_folder();

// What ffgpu's jobs said, each line once.
struct FlowMessages {
    std::vector<std::string> complaints, warnings;
};

// Returns when nothing more can be done. Throws InputError where Snakemake is not installed.
FlowMessages run_flow(const FlowOptions& options);

} // namespace ffgpu::tools
