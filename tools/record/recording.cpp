#include "tools/record/recording.h"

#include "model/base/input_error.h"
#include "tools/files/npy_file.h"
#include "tools/report/frame_image.h"

#include <algorithm>
#include <array>
#include <exception>
#include <thread>
#include <utility>

#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

FunctionalGpu::Config gpu_config(const RecordingOptions& options) {
    const GpuParameters& parameters = options.configuration.gpu;
    const unsigned processors = std::max(1u, std::thread::hardware_concurrency());
    if (options.stages)
        return {.threads = 1, .tile_size = parameters.tile_size, .stages = options.stages};
    return {.threads = parameters.threads == 0 ? processors : parameters.threads,
            .tile_size = parameters.tile_size,
            .stages = options.reference ? &ReferenceStages : &FastStages};
}

constexpr std::array<std::string_view, 3> PicturePrefixes{"frame_", "heat_", "view_"};

} // namespace

Recording::Recording(const RecordingOptions& options)
    : options_(options)
    , folder_(options.output, PicturePrefixes)
    , gpu_(gpu_config(options))
    , capture_(gpu_)
    , report_(options.configuration, options.timing)
    , statistics_(report_, pictures_, options.output)
    , pipeline_(pipeline_options(), report_) {
    if (pipeline_.sink()) sinks_.add(*pipeline_.sink());
    if (!options_.heat.maps.empty()) sinks_.add(heat_);
    // A capture in between costs its bookkeeping, so that it is there only if wanted; so the
    // others.
    Device* device = &gpu_;
    if (!options_.capture.empty()) device = &capture_;
    if (!options_.views.empty())
        device = &views_.emplace(*device, options_.views, gpu_config(options_));
    watch_draws(*device);
}

void Recording::watch_draws(Device& device) {
    if (!options_.draw_table && options_.steps == 0 && options_.draws == FrameRange{}) return;
    DrawWatch::Listener listener;
    if (options_.draw_table)
        listener.before = [this](const WatchedDraw& draw) { draw_comes(draw); };
    if (options_.steps > 0)
        listener.behind = [this](std::uint32_t draw, const Targets& targets) {
            draw_done(draw, targets);
        };
    watch_.emplace(device, options_.draws, std::move(listener));
}

void Recording::draw_comes(const WatchedDraw& draw) {
    if (!measuring_) return;
    DrawNote note{.draw = draw, .call = {}};
    if (calls_) {
        const auto waiting = calls_->waiting();
        note.call = waiting ? waiting->entries.front().call : calls_->call();
    }
    notes_.add(note);
}

void Recording::draw_done(std::uint32_t draw, const Targets& targets) {
    if (!measuring_) return;
    most_draws_ = std::max(most_draws_, ++draws_in_frame_);
    if (draws_in_frame_ % options_.steps != 0) return;
    gpu_.hide_from_work(true);
    try {
        images_.add(folder_.picture(fmt::format("frame_{:04}_draw", frame_), draw),
                    read_surface(gpu_, targets.color[0]));
    } catch (const InputError&) {
        // No fault of the command that is under way: it comes again behind the frame.
    }
    gpu_.hide_from_work(false);
}

// What the map shows is there in this machine.
void Recording::check_map(HeatMap map) const {
    const timing::TimingConfig& timing = options_.configuration.timing;
    const auto refuse = [&](bool is_there, const char* wanted) {
        if (!is_there)
            throw InputError(fmt::format("--heatmap {} needs {}", info(map).name, wanted));
    };
    if (map == HeatMap::StallCause) refuse(timing.bottlenecks.enable, "bottlenecks.enable=true");
    if (map == HeatMap::DepthBlocks)
        refuse(timing.depth_blocks.is_on(),
               "depth_blocks.fast_clear=true or depth_blocks.compression=true");
    if (map == HeatMap::ColorBlocks)
        refuse(timing.color_blocks.is_on(),
               "color_blocks.fast_clear=true or color_blocks.compression=true");
}

HeatPlane Recording::heat_plane(HeatMap map, const Surface& shown) const {
    if (map == HeatMap::DepthBlocks || map == HeatMap::ColorBlocks)
        return pipeline_.block_bytes(shown, map == HeatMap::DepthBlocks);
    return heat_.plane(map, shown);
}

WorkPipeline::Options Recording::pipeline_options() {
    bool needs_costs = false;
    for (const HeatMap map : options_.heat.maps) {
        if (!info(map).needs_timing) continue;
        if (!options_.timing)
            throw InputError("--heatmap " + std::string(info(map).name) + " needs --timing");
        needs_costs = true;
        check_map(map);
    }
    return {.timing = options_.timing ? &options_.configuration.timing : nullptr,
            .save_work = options_.save_work,
            .costs = needs_costs ? &heat_ : nullptr,
            .draw_table = options_.draw_table ? folder_.file("draws.csv") : "",
            .draw_notes = &notes_,
            .draw_pixels = options_.draw_pixels ? folder_.file("draw_pixels.csv") : "",
            .on_frame = [this](std::uint64_t cycles) { frame_timed(cycles); }};
}

Device& Recording::device() {
    if (watch_) return *watch_;
    if (views_) return *views_;
    return options_.capture.empty() ? static_cast<Device&>(gpu_) : capture_;
}

bool Recording::records_values() const {
    return options_.work_values ||
           (options_.timing && !options_.configuration.timing.needs_values().empty());
}

void Recording::listen() {
    if (sinks_.empty()) return;
    gpu_.set_work_sink(&sinks_, records_values() ? WorkDetail::Values : WorkDetail::Masks);
}

void Recording::start(std::uint64_t first_frame) {
    measuring_ = true;
    if (watch_) watch_->start();
    statistics_.begin();
    if (!options_.capture.empty())
        capture_.begin(options_.capture, static_cast<std::uint32_t>(first_frame));
    has_begun_ = true;
    gpu_.finish();
    counted_.take(gpu_.statistics());
    listen();
}

void Recording::number_from(std::uint64_t frame, std::uint32_t draw) {
    gpu_.number_from(static_cast<std::uint32_t>(frame), draw);
    capture_.number_draws_from(draw);
    if (watch_) watch_->number_from(draw);
}

void Recording::before_frame(std::uint64_t number) {
    if (!measuring_ && number >= options_.frames.first) start(number);
    frame_ = number;
    draws_in_frame_ = 0;
    if (!measuring_) return;
    heat_.clear();
}

bool Recording::after_frame(const Frame& frame) {
    if (!measuring_) return false;
    capture_.frame_shown(static_cast<std::uint32_t>(frame.number), frame.picture);
    gpu_.finish();
    const work::FrameFigures figures{.number = frame.number,
                                     .width = frame.picture.width,
                                     .height = frame.picture.height,
                                     .api_calls = frame.api_calls,
                                     .functional = counted_.take(gpu_.statistics())};
    pictures_.add(figures, pictures_of(frame.picture));
    pipeline_.frame(figures, frame.picture);
    has_frame_ = true;
    images_.check_failure();
    if (!options_.heat.maps.empty()) pipeline_.drain();
    // Looking at the picture is no work of the machine's.
    gpu_.hide_from_work(true);
    write_pictures(frame);
    gpu_.hide_from_work(false);
    return true;
}

void Recording::read_picture(DeviceAddress at, std::span<std::byte> bytes) {
    gpu_.hide_from_work(true);
    gpu_.read_memory(at, bytes);
    gpu_.hide_from_work(false);
}

void Recording::frame_timed(std::uint64_t cycles) {
    pictures_.timed(cycles);
    statistics_.frame_ended();
}

// By their names' beginnings: those that write_pictures() writes.
std::vector<std::string> Recording::pictures_of(const Surface& shown) const {
    std::vector<std::string> names;
    if (options_.output.empty() || shown.format == Format::None) return names;
    if (options_.images) names.emplace_back("frame");
    for (const HeatMap map : options_.heat.maps)
        names.push_back(fmt::format("heat_{}", info(map).name));
    for (const View view : options_.views)
        names.push_back(fmt::format("view_{}", info(view).name));
    return names;
}

void Recording::write_pictures(const Frame& frame) {
    if (options_.output.empty() || frame.picture.format == Format::None) return;
    for (const View view : options_.views)
        images_.add(folder_.picture(fmt::format("view_{}", info(view).name), frame.number),
                    views_->picture(view, frame.picture, gpu_));
    if (!options_.images && options_.heat.maps.empty()) return;
    Image picture = read_surface(gpu_, frame.picture);
    for (const HeatMap map : options_.heat.maps)
        write_heat_map(map, frame, picture);
    if (options_.images) images_.add(folder_.picture("frame", frame.number), std::move(picture));
}

void Recording::write_heat_map(HeatMap map, const Frame& frame, const Image& picture) {
    const HeatMapOptions& heat = options_.heat;
    HeatPlane plane = heat_plane(map, frame.picture);
    if (heat.tile > 1)
        plane =
            info(map).names.empty() ? averaged(plane, heat.tile) : most_common(plane, heat.tile);
    const std::string prefix = fmt::format("heat_{}", info(map).name);
    images_.add(folder_.picture(prefix, frame.number), heat_picture(map, plane, heat, picture));
    if (heat.raw)
        write_npy(folder_.picture(prefix, frame.number, "npy"), plane.width, plane.values);
}

void Recording::finish() {
    std::exception_ptr first_failure;
    const auto step = [&](const auto& call) {
        try {
            call();
        } catch (const std::runtime_error&) {
            if (!first_failure) first_failure = std::current_exception();
        }
    };
    step([&] { images_.finish(); });
    step([&] {
        if (has_frame_) capture_.end(); // One without a frame shows nothing, and is not kept.
    });
    step([&] {
        gpu_.finish();
        pipeline_.finish();
    });
    step([&] { statistics_.write(); });
    step([&] {
        if (!options_.output.empty()) pipeline_.write_series(options_.output);
    });
    if (first_failure) std::rethrow_exception(first_failure);
    tell_what_is_missing();
}

void Recording::tell_what_is_missing() const {
    if (const std::string older = folder_.older_pictures(); !older.empty()) options_.warn(older);
    // Where a file could not be begun that is the reason, and told already.
    const bool lacks_frames = !has_frame_ && has_begun_ == measuring_;
    for (const std::string& file : {options_.capture, options_.save_work})
        if (lacks_frames && !file.empty()) options_.warn(file + ": not written: there is no frame");
    if (!watch_) return;
    if (const std::string line = watch_->missing_draws(); !line.empty()) options_.warn(line);
    if (options_.steps > most_draws_)
        options_.warn(
            fmt::format("--steps {}: no frame has more than {} draws: there is no picture of them",
                        options_.steps,
                        most_draws_));
}

} // namespace ffgpu::tools
