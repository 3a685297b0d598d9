// Recording: the GPU, and all that looks at the frames drawn on it: pictures, heat maps, statistics
// with or without the timing model, a capture. Replays and live programs draw on its device.

#pragma once

#include "model/capture/capture_writer.h"
#include "model/gpu/functional_gpu.h"
#include "model/timing/gpu_timing.h"
#include "tools/config/configuration.h"
#include "tools/image/image_writer.h"
#include "tools/replay/frame_range.h"
#include "tools/replay/frame_source.h"
#include "tools/replay/heat_maps.h"
#include "tools/replay/statistics_report.h"
#include "tools/replay/work_fan_out.h"

#include <memory>
#include <optional>
#include <set>
#include <string>

namespace ffgpu::tools {

struct RecordingOptions {
    std::string output; // a folder; empty: nothing is written
    std::string capture;
    FrameRange frames;
    Configuration configuration;
    std::set<HeatMap> heat_maps;
    bool timing = false;
    bool images = true;
    bool reference = false; // draw with the scalar specifications
};

class Recording {
public:
    // Throws InputError, as all below, where a file cannot be written or options do not fit
    // together. `options` must outlive it.
    explicit Recording(const RecordingOptions& options);

    // To draw on.
    Device& device();
    FunctionalGpu& gpu() { return gpu_; }

    // From frame `number` on frames count, if it is the first of the range or beyond.
    void before_frame(std::uint64_t number);
    // The frame is done. True: it was measured.
    bool after_frame(const Frame& frame);

    // Completes the files.
    void finish();

    // A few lines for people.
    std::string summary() const { return report_.summary(); }

private:
    void make_output_folder();
    void connect_sinks();
    void start(std::uint64_t first_frame);
    void write_pictures(const Frame& frame);
    StatisticsReport::Groups timing_groups() const;

    const RecordingOptions& options_;
    FunctionalGpu gpu_;
    capture::CaptureWriter capture_;
    WorkFanOut sinks_;
    HeatMapRecorder heat_;
    std::unique_ptr<timing::GpuTiming> timing_;
    std::optional<timing::FrameTiming> cycles_;
    StatisticsReport report_;
    ImageWriter images_;
    bool measuring_ = false;
};

} // namespace ffgpu::tools
