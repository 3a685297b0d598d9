#include "tools/sweep/sweep.h"

#include "model/base/input_error.h"
#include "model/base/whole_file.h"
#include "tools/report/statistics_file.h"
#include "tools/sweep/pareto_plot.h"
#include "tools/sweep/snakemake.h"
#include "tools/sweep/sweep_table.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

namespace ffgpu::tools {

namespace fs = std::filesystem;

namespace {

// One sweep at a time in a folder. Snakemake holds it, too: one that outlives its sweep finishes
// the jobs it has begun before another begins.
class FolderLock {
public:
    explicit FolderLock(const fs::path& folder) {
        const std::string path = folder / ".lock";
        file_ = ::open(path.c_str(), O_RDWR | O_CREAT, 0666);
        if (file_ < 0) throw InputError(path + ": " + std::strerror(errno));
        if (::flock(file_, LOCK_EX | LOCK_NB) == 0) return;
        std::fprintf(stderr, "ffgpu: warning: %s: waiting for another sweep\n", folder.c_str());
        while (::flock(file_, LOCK_EX) != 0)
            if (errno != EINTR) throw InputError(path + ": " + std::strerror(errno));
    }
    ~FolderLock() { ::close(file_); }
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

private:
    int file_ = -1;
};

void write_whole(const fs::path& path, const std::string& text) {
    WholeFile file(path.string());
    file.write(text);
    file.commit();
}

// What killed jobs left half written; nobody writes here any more.
void remove_unfinished(const fs::path& folder) {
    std::error_code ignored;
    for (const char* const part : {"work", "results", "points"})
        for (const auto& entry : fs::recursive_directory_iterator(folder / part, ignored)) {
            const std::string name = entry.path().filename().string();
            if (name.find(".part") != std::string::npos) fs::remove(entry.path(), ignored);
        }
}

// What Snakemake takes for its outputs (sweep.smk): of this run alone, and of the work that is
// there.
void renew_marks(const SweepPlan& plan) {
    const fs::path marks = plan.folder / "marks";
    std::error_code ignored;
    fs::remove_all(marks, ignored);
    make_folder((marks / "work").string());
    for (const SweepTrace& trace : plan.traces)
        if (!trace.is_work && fs::exists(plan.work(trace)))
            write_whole(marks / "work" / trace.id, "");
}

void write_plots(const SweepPlan& plan, const std::vector<SweepRow>& rows) {
    for (const SweepTrace& trace : plan.traces) {
        ParetoPlot bytes{trace.name + ": cycles and bytes of memory traffic", "bytes", {}};
        ParetoPlot cost{trace.name + ": cycles and cost", "LUTs, and a LUT a 16 bits of cache", {}};
        for (const SweepRow& row : rows) {
            if (row.trace != &trace || row.is_stuck) continue;
            const auto cycles = static_cast<double>(row.cycles);
            bytes.points.push_back({static_cast<double>(row.memory_bytes),
                                    cycles,
                                    row.is_best_by_bytes,
                                    row.point->id});
            if (row.cost > 0)
                cost.points.push_back(
                    {static_cast<double>(row.cost), cycles, row.is_best_by_cost, row.point->id});
        }
        write_whole(plan.folder / ("pareto_bytes_" + trace.name + ".svg"), svg(bytes));
        if (!cost.points.empty())
            write_whole(plan.folder / ("pareto_cost_" + trace.name + ".svg"), svg(cost));
    }
}

std::string point_text(const SweepPlan& plan, const SweepRow& row) {
    std::string text = fmt::format("  {} {}: {} cycles, {:.1f} MB",
                                   row.trace->name,
                                   row.point->id,
                                   row.cycles,
                                   1e-6 * static_cast<double>(row.memory_bytes));
    for (std::size_t i = 0; i < plan.space.parameters.size(); ++i)
        text += fmt::format(", {} = {}", plan.space.parameters[i], row.point->values[i]);
    return text + '\n';
}

std::string summary(const SweepPlan& plan, const std::vector<SweepRow>& rows, std::size_t made) {
    std::string text = fmt::format("{} points, {} {}: {} results, {} of them made now\n",
                                   plan.space.points.size(),
                                   plan.traces.size(),
                                   plan.traces.size() == 1 ? "trace" : "traces",
                                   rows.size(),
                                   made);
    for (const SweepTrace& trace : plan.traces) {
        const SweepRow* fastest = nullptr;
        for (const SweepRow& row : rows)
            if (row.trace == &trace && !row.is_stuck && (!fastest || row.cycles < fastest->cycles))
                fastest = &row;
        if (!fastest) continue;
        text += "fastest:\n" + point_text(plan, *fastest);
        text += fmt::format("  all of it on a page: ffgpu report {} --point {} --trace {}\n",
                            plan.folder.string(),
                            fastest->point->id,
                            trace.name);
    }
    return text;
}

// One line: the first complaint, or what is missing.
[[noreturn]] void
fail(const SweepPlan& plan, const std::vector<std::string>& complaints, std::size_t missing) {
    throw InputError(fmt::format("sweep: {} of {} results are missing ({}): {}",
                                 missing,
                                 plan.space.points.size() * plan.traces.size(),
                                 "the finished ones are kept, the same command makes the rest",
                                 complaints.empty() ? "see " + (plan.folder / "log").string()
                                                    : complaints.front()));
}

std::string left_out_text(const std::string& path, const DesignSpace& space) {
    return fmt::format("{}: {} combinations of {} are no machines, and left out: {}",
                       path,
                       space.left_out,
                       space.left_out + space.points.size(),
                       space.why);
}

// The first few; all of them are in the logs.
void tell_warnings(const SweepPlan& plan, const std::vector<std::string>& warnings) {
    constexpr std::size_t Told = 5;
    for (std::size_t i = 0; i < std::min(Told, warnings.size()); ++i)
        std::fprintf(stderr, "ffgpu: warning: %s\n", warnings[i].c_str());
    if (warnings.size() > Told)
        std::fprintf(stderr,
                     "ffgpu: warning: %zu more of its jobs' warnings are in %s\n",
                     warnings.size() - Told,
                     (plan.folder / "log").c_str());
}

std::size_t count_missing(const SweepPlan& plan) {
    std::size_t missing = 0;
    for (const SweepTrace& trace : plan.traces)
        for (const DesignPoint& point : plan.space.points)
            missing += !fs::exists(plan.result(trace, point));
    return missing;
}

} // namespace

std::string sweep(const SweepOptions& options) {
    const UnitCosts units = read_unit_costs(find_flow_folder() / "rtl_cost.md");
    SweepPlan plan;
    plan.space = read_design_space(options.space);
    if (plan.space.left_out > 0)
        std::fprintf(
            stderr, "ffgpu: warning: %s\n", left_out_text(options.space, plan.space).c_str());
    plan.frames_text = options.frames;
    if (!options.frames.empty()) plan.frames = parse_frame_range(options.frames);
    plan.traces = sweep_traces(options.traces, options.frames);
    make_folder(options.output);
    plan.folder = fs::absolute(options.output);
    const FolderLock lock(plan.folder);
    const std::size_t missing = write_plan(plan, options.version);
    FlowMessages said;
    if (missing > 0) {
        renew_marks(plan);
        said = run_flow({plan.folder, options.profile, options.cores, missing});
    }
    const std::size_t still_missing = count_missing(plan);
    const std::vector<SweepRow> rows = read_results(plan, units);
    try {
        write_whole(plan.folder / "results.csv", table_text(plan, rows));
        write_plots(plan, rows);
    } catch (const InputError&) {
        if (still_missing == 0) throw;
    }
    if (still_missing > 0) fail(plan, said.complaints, still_missing);
    tell_warnings(plan, said.warnings);
    remove_unfinished(plan.folder);
    return summary(plan, rows, missing);
}

} // namespace ffgpu::tools
