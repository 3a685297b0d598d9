#include "tools/explain/explain.h"

#include "model/base/input_error.h"
#include "model/memory/pixel_format.h"
#include "tools/explain/explain_frame.h"
#include "tools/frames/frame_source.h"

#include <algorithm>
#include <optional>
#include <thread>

#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

FunctionalGpu::Config gpu_config(const GpuParameters& parameters) {
    const unsigned processors = std::max(1u, std::thread::hardware_concurrency());
    return {.threads = parameters.threads == 0 ? processors : parameters.threads,
            .tile_size = parameters.tile_size};
}

} // namespace

ExplainedFrame::ExplainedFrame(const ExplainOptions& options)
    : options_(options)
    , gpu_(std::make_unique<FunctionalGpu>(gpu_config(options.configuration.gpu)))
    , device_(std::make_unique<TapeDevice>(*gpu_))
    , picture_(play()) {
    if (picture_.format == Format::None)
        throw InputError(fmt::format("{}: frame {} has no picture", options.input, options.frame));
}

Surface ExplainedFrame::play() {
    CallLog calls;
    const auto source =
        open_frame_source(options_.input,
                          *device_,
                          {.warn = options_.warn,
                           .samples = options_.samples,
                           .swap = options_.swap,
                           .panel = options_.configuration.gpu.panel(),
                           .on_call = [&calls](std::uint64_t number, std::string_view name) {
                               calls.begin(number, name);
                           }});
    from_trace_ = source->has_calls();
    device_->number_draws_from(source->prepare());
    std::uint64_t next = source->first_frame();
    if (options_.frame < next)
        throw InputError(fmt::format(
            "--frame {}: {} begins with frame {}", options_.frame, options_.input, next));
    for (;;) {
        if (next == options_.frame)
            device_->start(static_cast<std::uint32_t>(next), from_trace_ ? &calls : nullptr);
        const std::optional<Frame> frame = source->next();
        if (!frame)
            throw InputError(fmt::format(
                "--frame {}: {} ends before frame {}", options_.frame, options_.input, next));
        if (frame->number == options_.frame) {
            gpu_->finish();
            return frame->picture;
        }
        next = frame->number + 1;
    }
}

std::vector<std::uint32_t> ExplainedFrame::values(const std::vector<PicturePixel>& pixels) const {
    std::vector<std::uint32_t> values;
    std::array<std::byte, 4> bytes{};
    const auto pixel_bytes = std::span(bytes).first(format_info(picture_.format).block_bytes);
    for (const auto& [x, y] : pixels) {
        if (x >= picture_.width || y >= picture_.height)
            throw InputError(fmt::format("pixel {},{}: the picture has {}x{} pixels",
                                         x,
                                         y,
                                         picture_.width,
                                         picture_.height));
        const SurfacePixel pixel{picture_, x, picture_.height - 1u - y};
        gpu_->read_memory(static_cast<DeviceAddress>(pixel.address()), pixel_bytes);
        values.push_back(load_rgba8(picture_.format, bytes.data()));
    }
    return values;
}

std::vector<PixelHistory> ExplainedFrame::histories(const std::vector<PicturePixel>& pixels,
                                                    WorkSink* work) const {
    std::vector<PixelHistory> histories =
        explain_frame({.tape = device_->tape(),
                       .picture = picture_,
                       .pixels = pixels,
                       .values = values(pixels),
                       .timing = options_.timing ? &options_.configuration.timing : nullptr,
                       .work = work});
    for (PixelHistory& history : histories)
        history.from_trace = from_trace_;
    return histories;
}

} // namespace ffgpu::tools
