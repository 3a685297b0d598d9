#include "tools/record/recording.h"

#include "model/base/input_error.h"
#include "tools/files/whole_file.h"
#include "tools/replay/frame_image.h"

#include <algorithm>
#include <filesystem>
#include <thread>

#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

FunctionalGpu::Config gpu_config(const RecordingOptions& options) {
    const GpuParameters& parameters = options.configuration.gpu;
    const unsigned processors = std::max(1u, std::thread::hardware_concurrency());
    return {.threads = parameters.threads == 0 ? processors : parameters.threads,
            .tile_size = parameters.tile_size,
            .stages = options.reference ? &ReferenceStages : &FastStages};
}

} // namespace

Recording::Recording(const RecordingOptions& options)
    : options_(options)
    , gpu_(gpu_config(options))
    , capture_(gpu_)
    , report_(options.configuration, options.timing) {
    for (const HeatMap map : options.heat_maps)
        if (info(map).needs_timing && !options.timing)
            throw InputError("--heatmap " + std::string(info(map).name) + " needs --timing");
    make_output_folder();
    connect_sinks();
}

// A capture in between costs its bookkeeping, so that it is there only if wanted.
Device& Recording::device() {
    return options_.capture.empty() ? static_cast<Device&>(gpu_) : capture_;
}

void Recording::make_output_folder() {
    if (options_.output.empty()) return;
    std::error_code error;
    std::filesystem::create_directories(options_.output, error);
    if (error) throw InputError(options_.output + ": cannot be made: " + error.message());
}

void Recording::connect_sinks() {
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

void Recording::start(std::uint64_t first_frame) {
    measuring_ = true;
    if (!options_.capture.empty())
        capture_.begin(options_.capture, static_cast<std::uint32_t>(first_frame));
    if (!sinks_.empty()) gpu_.set_work_sink(&sinks_);
}

void Recording::before_frame(std::uint64_t number) {
    if (!measuring_ && number >= options_.frames.first) start(number);
    if (!measuring_) return;
    report_.begin_frame(gpu_.statistics(), timing_groups());
    heat_.clear();
    cycles_.reset();
}

bool Recording::after_frame(const Frame& frame) {
    if (!measuring_) return false;
    capture_.frame_shown(static_cast<std::uint32_t>(frame.number), frame.picture);
    gpu_.finish();
    report_.end_frame(frame, gpu_.statistics(), timing_groups(), cycles_);
    // Looking at the picture is no work of the machine's.
    sinks_.set_open(false);
    write_pictures(frame);
    sinks_.set_open(true);
    return true;
}

StatisticsReport::Groups Recording::timing_groups() const {
    return timing_ ? timing_->statistics() : StatisticsReport::Groups{};
}

void Recording::write_pictures(const Frame& frame) {
    if (options_.output.empty() || frame.picture.format == Format::None) return;
    const auto path = [&](std::string_view prefix) {
        const std::string name = fmt::format("{}_{:04}.png", prefix, frame.number);
        return (std::filesystem::path(options_.output) / name).string();
    };
    if (options_.images) images_.add(path("frame"), read_surface(gpu_, frame.picture));
    for (const HeatMap map : options_.heat_maps)
        images_.add(path(fmt::format("heat_{}", info(map).name)), heat_.image(map, frame.picture));
}

void Recording::finish() {
    images_.finish();
    capture_.end();
    if (options_.output.empty()) return;
    const auto path = (std::filesystem::path(options_.output) / "stats.json").string();
    WholeFile file(path);
    report_.write([&file](std::string_view text) { file.write(text); });
    file.commit();
}

} // namespace ffgpu::tools
