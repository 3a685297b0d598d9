// WorkPipeline: what reads the work stream beside the drawing, on a thread of its own: the machine
// in time, and the file that keeps the work. The statistics of a frame are put together where the
// machine runs, because only there is it known what the frame took.

#pragma once

#include "model/timing/gpu_timing.h"
#include "model/work/command_assembler.h"
#include "model/work/sink_thread.h"
#include "model/work/work_file_writer.h"
#include "tools/draws/draw_table.h"
#include "tools/heatmap/heat_recorder.h"
#include "tools/record/draw_pixels.h"
#include "tools/record/work_fan_out.h"
#include "tools/report/frame_meter.h"
#include "tools/report/series_file.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace ffgpu::tools {

class WorkPipeline {
public:
    struct Options {
        const timing::TimingConfig* timing = nullptr; // null: no machine in time
        std::string save_work;                        // empty: no file
        HeatRecorder* costs = nullptr;                // of quads; needs timing; read after drain()
        std::string draw_table{};                     // the path of draws.csv; empty: none
        DrawNotes* draw_notes = nullptr;              // for it
        std::string draw_pixels{};                    // the path of draw_pixels.csv; empty: none
        // A frame's figures are in the report, and it took so many cycles; not the caller's thread.
        std::function<void(std::uint64_t cycles)> on_frame = [](std::uint64_t) {};
    };

    // Throws InputError where the file cannot be made.
    WorkPipeline(const Options& options, StatisticsReport& report);

    // What it reads; null: nothing.
    WorkSink* sink() { return thread_ ? &*thread_ : nullptr; }

    // The frame's work is handed over. Throws what went wrong in earlier frames.
    void frame(const work::FrameFigures& figures, const Surface& shown);

    // Returns when all is read, and counted in the report. Throws what went wrong.
    void drain();
    // The same at the end: completes the file.
    void finish();
    // After drain(): bytes that the blocks of the frame's pixels take in the machine's memory, of
    // depths or colours.
    HeatPlane block_bytes(const Surface& shown, bool depth) const;
    // After drain(): the machine's series, if its configuration wants one.
    void write_series(const std::string& folder) const;

private:
    void add(const work::FrameFigures& figures, const Surface& shown);

    std::optional<SeriesFile> series_;
    std::unique_ptr<DrawTable> table_;
    std::unique_ptr<timing::GpuTiming> timing_; // tells series_ and table_
    std::unique_ptr<work::WorkFileWriter> file_;
    bool has_frame_ = false; // the thread's, until it is drained
    std::unique_ptr<DrawPixels> draw_pixels_;
    HeatRecorder* costs_ = nullptr;
    std::function<void(std::uint64_t cycles)> on_frame_;
    FrameMeter meter_; // Its machine tells those above.
    CommandFanOut readers_;
    work::CommandAssembler assembler_;
    std::optional<work::SinkThread> thread_; // The last: it uses the others.
};

} // namespace ffgpu::tools
