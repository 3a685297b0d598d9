// SweepPlan: what a sweep consists of, and where each part of it lies in its folder. What is there
// whole is done: files are written under other names and renamed.
//
//     plan.json              what Snakemake's rules read
//     work/TRACE.ffw         the work of a trace, drawn once; TRACE.values.ffw: with values
//     points/POINT.toml      a machine, every parameter
//     results/TRACE/POINT.json   the totals of one job
//     results.csv, pareto_*.svg  the table, when all is done

#pragma once

#include "tools/frames/frame_range.h"
#include "tools/sweep/design_space.h"

#include <filesystem>
#include <string>
#include <vector>

namespace ffgpu::tools {

struct SweepTrace {
    std::string name; // the file's, without its extension
    std::string id;   // name and a hash of the content and the frames
    std::filesystem::path path;
    bool is_work = false; // It is a work file: nothing is drawn.
};

struct SweepPlan {
    std::filesystem::path folder;
    FrameRange frames;
    std::string frames_text; // as it was given
    DesignSpace space;
    std::vector<SweepTrace> traces;

    // Whether some point needs work with values, which the others are timed by, too.
    bool needs_values() const;
    std::filesystem::path work(const SweepTrace& trace) const;
    std::filesystem::path point_file(const DesignPoint& point) const;
    std::filesystem::path result(const SweepTrace& trace, const DesignPoint& point) const;
};

// Of the file, and of what was chosen of it. Throws InputError where it cannot be read.
std::string content_hash(const std::string& path, const std::string& choice);

// Throws InputError: a trace that cannot be read or whose name is another's, a work file of another
// version, frames that a work file cannot be cut to.
std::vector<SweepTrace> sweep_traces(const std::vector<std::string>& paths,
                                     const std::string& frames_text);

// Writes plan.json and the points' files; those that are there stay as they are. Throws InputError
// where a file cannot be written, or the folder is that of a sweep by another version or build of
// ffgpu. Returns how many results are missing.
std::size_t write_plan(const SweepPlan& plan, const std::string& version);

} // namespace ffgpu::tools
