// Recording: the GPU, and all that looks at the frames drawn on it: pictures, heat maps, statistics
// with or without the timing model, a capture, a work file. Replays and live programs draw on its
// device.

#pragma once

#include "model/capture/capture_writer.h"
#include "model/gpu/functional_gpu.h"
#include "tools/config/configuration.h"
#include "tools/draws/draw_notes.h"
#include "tools/draws/draw_watch.h"
#include "tools/frames/call_log.h"
#include "tools/frames/frame.h"
#include "tools/frames/frame_range.h"
#include "tools/heatmap/heat_picture.h"
#include "tools/image/image_writer.h"
#include "tools/record/output_folder.h"
#include "tools/record/work_fan_out.h"
#include "tools/record/work_pipeline.h"
#include "tools/report/counter_changes.h"
#include "tools/report/current_statistics.h"
#include "tools/report/picture_list.h"
#include "tools/report/statistics_report.h"
#include "tools/views/view_device.h"

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace ffgpu::tools {

struct RecordingOptions {
    std::string output; // a folder; empty: nothing is written
    std::string capture;
    std::string save_work;
    FrameRange frames;
    Configuration configuration;
    HeatMapOptions heat;
    std::set<View> views;
    FrameRange draws;         // others cover nothing
    unsigned steps = 0;       // a picture behind each so many draws of a frame; 0: none
    bool draw_table = false;  // draws.csv
    bool draw_pixels = false; // draw_pixels.csv
    bool timing = false;
    bool work_values = false; // Work tells values, too.
    bool images = true;
    bool reference = false;         // draw with the scalar specifications
    const Stages* stages = nullptr; // draw with these, on one thread
    std::function<void(const std::string& line)> warn = [](const std::string&) {};
};

class Recording {
public:
    // Throws InputError, as all below, where a file cannot be written or options do not fit
    // together. `options` must outlive it.
    explicit Recording(const RecordingOptions& options);

    // To draw on.
    Device& device();
    // Of a trace: which call is played.
    void set_calls(const CallLog* calls) { calls_ = calls; }
    FunctionalGpu& gpu() { return gpu_; }

    // The frame under way and the next draw have these numbers.
    void number_from(std::uint64_t frame, std::uint32_t draw);
    // From frame `number` on frames count, if it is the first of the range or beyond.
    void before_frame(std::uint64_t number);
    // The frame is done. True: it was measured.
    bool after_frame(const Frame& frame);

    // Bytes of device memory, read as a person looks at them: no work of the machine's.
    void read_picture(DeviceAddress at, std::span<std::byte> bytes);

    // Completes the files, as far as it can where something goes wrong.
    void finish();

    // A few lines for people.
    std::string summary() const { return report_.summary(); }

private:
    void listen();
    bool records_values() const;
    WorkPipeline::Options pipeline_options();
    void start(std::uint64_t first_frame);
    std::vector<std::string> pictures_of(const Surface& shown) const;
    void frame_timed(std::uint64_t cycles);
    void write_pictures(const Frame& frame);
    void watch_draws(Device& device);
    void draw_comes(const WatchedDraw& draw);
    void draw_done(std::uint32_t draw, const Targets& targets);
    void tell_what_is_missing() const;
    void check_map(HeatMap map) const;
    HeatPlane heat_plane(HeatMap map, const Surface& shown) const;
    void write_heat_map(HeatMap map, const Frame& frame, const Image& picture);

    const RecordingOptions& options_;
    OutputFolder folder_;
    FunctionalGpu gpu_;
    capture::CaptureWriter capture_;
    HeatRecorder heat_;
    StatisticsReport report_;
    PictureList pictures_;
    CurrentStatistics statistics_;
    DrawNotes notes_;
    WorkPipeline pipeline_;
    WorkFanOut sinks_;
    CounterChanges counted_; // of the functional GPU
    ImageWriter images_;
    std::optional<ViewDevice> views_;
    std::optional<DrawWatch> watch_;
    const CallLog* calls_ = nullptr;
    std::uint64_t frame_ = 0;                      // under way
    unsigned draws_in_frame_ = 0, most_draws_ = 0; // counted where there are steps
    bool measuring_ = false, has_begun_ = false, has_frame_ = false;
};

} // namespace ffgpu::tools
