#include "tools/commands/sweep_command.h"

#include "tools/frames/frame_range.h"
#include "tools/sweep/sweep.h"

#include <cstdio>
#include <limits>
#include <memory>

#include <CLI/CLI.hpp>

namespace ffgpu::tools {

void add_sweep_command(CLI::App& application, Run& run, const char* version) {
    const auto options = std::make_shared<SweepOptions>();
    options->version = version;
    CLI::App* const verb = application.add_subcommand(
        "sweep", "Runs the machine in time over a design space, as jobs that can be resumed");
    verb->add_option("space", options->space, "The space: grids, lists, random samples (TOML)")
        ->type_name("SPACE.toml")
        ->required();
    verb->add_option("traces", options->traces, "Traces, captures, or work files (.ffw)")
        ->type_name("TRACE...")
        ->required();
    verb->add_option("-o,--output", options->output, "Folder for the table and all that it is of")
        ->type_name("DIR")
        ->required();
    verb->add_option("--frames", options->frames, "Of each trace, only these")
        ->type_name("A-B")
        ->each(check_frame_range);
    verb->add_option("--cores", options->cores, "Jobs at a time on this machine; all, if not told")
        ->check(CLI::Range(1u, std::numeric_limits<unsigned>::max()))
        ->type_name("N");
    verb->add_option("--profile", options->profile, "slurm, or a profile of Snakemake's")
        ->type_name("NAME");
    verb->footer("Example: ffgpu sweep caches.toml traces/corridor.trace -o out/caches");
    verb->callback([options, &run] {
        run = [options] {
            std::fputs(sweep(*options).c_str(), stderr);
            return 0;
        };
    });
}

} // namespace ffgpu::tools
