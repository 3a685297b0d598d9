#include "tools/replay/replay.h"

#include "model/base/input_error.h"
#include "model/capture/capture_writer.h"
#include "model/gpu/functional_gpu.h"
#include "model/timing/gpu_timing.h"
#include "tools/image/image_writer.h"
#include "tools/replay/frame_image.h"
#include "tools/replay/frame_source.h"
#include "tools/replay/progress.h"
#include "tools/replay/statistics_report.h"
#include "tools/replay/work_fan_out.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <memory>
#include <thread>

#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

FunctionalGpu::Config gpu_config(const GpuParameters& parameters) {
    const unsigned processors = std::max(1u, std::thread::hardware_concurrency());
    return {.threads = parameters.threads == 0 ? processors : parameters.threads,
            .tile_size = parameters.tile_size};
}

class Replay {
public:
    explicit Replay(const ReplayOptions& options)
        : options_(options)
        , gpu_(gpu_config(options.configuration.gpu))
        , capture_(gpu_)
        , report_(options.configuration, options.timing)
        , source_(open_frame_source(options.input,
                                    device(),
                                    {.warn = options.warn,
                                     .report_errors = options.report_errors,
                                     .keep_last = options.benchmark > 0})) {
        make_output_folder();
        connect_sinks();
    }

    std::string run() {
        try {
            play();
        } catch (const InputError&) {
            finish(); // What is done stays.
            throw;
        }
        finish();
        return report_.summary() + benchmark_line_;
    }

private:
    // A capture in between costs its bookkeeping, so that it is there only if wanted.
    Device& device() { return options_.capture.empty() ? static_cast<Device&>(gpu_) : capture_; }

    void make_output_folder() {
        if (options_.output.empty()) return;
        std::error_code error;
        std::filesystem::create_directories(options_.output, error);
        if (error) throw InputError(options_.output + ": cannot be made: " + error.message());
    }

    void connect_sinks() {
        if (options_.timing) {
            timing_ = std::make_unique<timing::GpuTiming>(options_.configuration.timing);
            timing_->set_on_frame([this](const timing::FrameTiming& frame) { cycles_ = frame; });
            if (!options_.heat_maps.empty())
                timing_->set_on_retire(
                    [this](const timing::QuadRetired& quad) { heat_.quad_retired(quad); });
            sinks_.add(*timing_);
        }
        if (!options_.heat_maps.empty()) sinks_.add(heat_);
    }

    void play() {
        Progress progress(options_.frames.last < ~std::uint64_t{0}
                              ? std::optional(options_.frames.last)
                              : std::nullopt);
        std::uint64_t next = source_->first_frame();
        do {
            if (next >= options_.frames.first) start_measuring(next);
            if (measuring_) begin_frame();
            const std::optional<Frame> frame = source_->next();
            if (!frame) break;
            if (measuring_) end_frame(*frame);
            progress.show(frame->number);
            next = frame->number + 1;
        } while (next <= options_.frames.last);
        if (options_.benchmark > 0) benchmark();
    }

    void start_measuring(std::uint64_t first_frame) {
        if (measuring_) return;
        measuring_ = true;
        if (!options_.capture.empty())
            capture_.begin(options_.capture, static_cast<std::uint32_t>(first_frame));
        if (!sinks_.empty()) gpu_.set_work_sink(&sinks_);
        started_ = std::chrono::steady_clock::now();
    }

    StatisticsReport::Groups timing_groups() const {
        return timing_ ? timing_->statistics() : StatisticsReport::Groups{};
    }

    void begin_frame() {
        report_.begin_frame(gpu_.statistics(), timing_groups());
        heat_.clear();
        cycles_.reset();
    }

    void end_frame(const Frame& frame) {
        capture_.frame_shown(static_cast<std::uint32_t>(frame.number), frame.picture);
        gpu_.finish();
        report_.end_frame(frame, gpu_.statistics(), timing_groups(), cycles_);
        ++measured_;
        // Looking at the picture is no work of the machine's.
        sinks_.set_open(false);
        write_pictures(frame);
        sinks_.set_open(true);
    }

    void write_pictures(const Frame& frame) {
        if (options_.output.empty() || frame.picture.format == Format::None) return;
        const auto path = [&](std::string_view prefix) {
            const std::string name = fmt::format("{}_{:04}.png", prefix, frame.number);
            return (std::filesystem::path(options_.output) / name).string();
        };
        if (options_.images) images_.add(path("frame"), read_surface(gpu_, frame.picture));
        for (const HeatMap map : options_.heat_maps)
            images_.add(path(fmt::format("heat_{}", info(map).name)),
                        heat_.image(map, frame.picture));
    }

    // Frames a second from the first measured frame on, then of the last frame alone.
    void benchmark() {
        using Seconds = std::chrono::duration<double>;
        const auto now = [] { return std::chrono::steady_clock::now(); };
        benchmark_line_ = fmt::format("{:.2f} frames/s over {} frames\n",
                                      measured_ / Seconds(now() - started_).count(),
                                      measured_);
        const auto start = now();
        for (unsigned i = 0; i < options_.benchmark; ++i)
            if (!source_->repeat_last()) return;
        gpu_.finish();
        const double seconds = Seconds(now() - start).count();
        benchmark_line_ += fmt::format("{:.2f} frames/s, {:.3f} ms/frame over the last frame, {} "
                                       "times\n",
                                       options_.benchmark / seconds,
                                       1000 * seconds / options_.benchmark,
                                       options_.benchmark);
    }

    void finish() {
        images_.finish();
        capture_.end();
        if (options_.output.empty()) return;
        const auto path = (std::filesystem::path(options_.output) / "stats.json").string();
        std::ofstream file(path, std::ios::binary);
        if (!(file << report_.to_json()).flush()) throw InputError(path + ": cannot be written");
    }

    const ReplayOptions& options_;
    FunctionalGpu gpu_;
    capture::CaptureWriter capture_;
    WorkFanOut sinks_;
    HeatMapRecorder heat_;
    std::unique_ptr<timing::GpuTiming> timing_;
    std::optional<timing::FrameTiming> cycles_;
    StatisticsReport report_;
    ImageWriter images_;
    std::unique_ptr<FrameSource> source_; // Plays on what is above.
    bool measuring_ = false;
    unsigned measured_ = 0;
    std::chrono::steady_clock::time_point started_{};
    std::string benchmark_line_;
};

} // namespace

std::string replay(const ReplayOptions& options) {
    for (const HeatMap map : options.heat_maps)
        if (info(map).needs_timing && !options.timing)
            throw InputError("--heatmap " + std::string(info(map).name) + " needs --timing");
    return Replay(options).run();
}

} // namespace ffgpu::tools
