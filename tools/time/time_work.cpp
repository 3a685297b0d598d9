#include "tools/time/time_work.h"

#include "model/base/input_error.h"
#include "model/timing/gpu_timing.h"
#include "model/work/work_file_reader.h"
#include "tools/frames/progress.h"
#include "tools/report/frame_meter.h"
#include "tools/report/statistics_file.h"

#include <optional>

namespace ffgpu::tools {

std::string time_work(const TimeOptions& options) {
    work::WorkFileReader file(options.input);
    make_folder(options.output);
    timing::GpuTiming timing(options.configuration.timing);
    StatisticsReport report(options.configuration, true);
    FrameMeter meter(report, &timing);
    try {
        Progress progress(std::nullopt);
        file.play(timing, [&](const work::FrameFigures& frame) {
            meter.add(frame);
            progress.show(frame.number);
        });
    } catch (const InputError&) {
        write_statistics_file(report, options.output); // What is done stays.
        throw;
    }
    write_statistics_file(report, options.output);
    return report.summary();
}

} // namespace ffgpu::tools
