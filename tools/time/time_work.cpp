#include "tools/time/time_work.h"

#include "model/timing/gpu_timing.h"
#include "model/timing/machine_stuck.h"
#include "model/work/work_file_reader.h"
#include "tools/files/made_folder.h"
#include "tools/frames/progress.h"
#include "tools/replay/interruption.h"
#include "tools/report/frame_meter.h"
#include "tools/report/series_file.h"
#include "tools/report/statistics_file.h"
#include "tools/time/measured_gains.h"

#include <exception>
#include <optional>
#include <stdexcept>

namespace ffgpu::tools {

namespace {

// Returns, or throws what went wrong first, when the machine has carried out all that was read.
void play(work::WorkFileReader& file, timing::GpuTiming& timing, FrameMeter& meter) {
    Progress progress(std::nullopt);
    std::exception_ptr failure;
    try {
        file.play(timing, [&](const work::FrameFigures& frame) {
            meter.add(frame, [&, number = frame.number](const auto*) { progress.show(number); });
            if (Interruption::signal() != 0) file.stop();
        });
    } catch (...) { // The machine may still be at what came before.
        failure = std::current_exception();
    }
    timing.catch_up();
    if (failure) std::rethrow_exception(failure);
}

} // namespace

std::string time_work(const TimeOptions& options) {
    work::WorkFileReader file(options.input);
    const MadeFolder folder(options.output);
    std::optional<SeriesFile> series; // The machine uses it.
    timing::GpuTiming timing(options.configuration.timing);
    StatisticsReport report(options.configuration, true);
    FrameMeter meter(report, &timing);
    if (options.configuration.timing.series.interval_cycles > 0) series.emplace(timing);
    const auto write = [&] {
        if (options.output.empty()) return;
        remove_gains_file(options.output);
        write_statistics_file(report, options.output);
        if (series) series->write(options.output);
    };
    try {
        play(file, timing, meter);
    } catch (const timing::MachineStuck&) {
        write();
        write_totals_file(report, options.totals, true);
        throw;
    } catch (const std::runtime_error&) {
        if (report.has_frames()) write(); // What is done stays. They are no totals.
        throw;
    }
    write();
    if (Interruption::signal() != 0) return report.summary(); // The sums are no totals.
    write_totals_file(report, options.totals, false);
    if (!options.measure_gains) return report.summary();
    const std::vector<FrameGains> gains =
        measure_gains(options.input, options.configuration.timing);
    if (Interruption::signal() != 0) return report.summary();
    write_gains_file(gains, options.output);
    return report.summary() + gains_summary(gains);
}

} // namespace ffgpu::tools
