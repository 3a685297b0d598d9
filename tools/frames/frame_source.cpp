#include "tools/frames/frame_source.h"

#include "driver/trace/player/player.h"
#include "model/base/input_error.h"
#include "model/capture/capture_reader.h"
#include "model/work/work_file_reader.h"
#include "tools/frames/failure_keeper.h"

#include <utility>

namespace ffgpu::tools {
namespace {

class TraceSource : public FrameSource {
public:
    TraceSource(const std::string& path, Device& device, const FrameSourceOptions& options)
        : reader_(path)
        , device_(device)
        , player_(device_,
                  reader_,
                  {.warn = options.warn,
                   .report_errors = options.report_errors,
                   .keep_last_frame = options.keep_last,
                   .samples = options.samples,
                   .swap = options.swap,
                   .panel = options.panel,
                   .on_call = pass_on(options)}) {}

    std::optional<Frame> next() override {
        const std::uint64_t before = player_.calls_played();
        const auto shown = player_.play_frame();
        device_.check_failure();
        if (!shown) return std::nullopt;
        return Frame{shown->number, shown->picture, player_.calls_played() - before};
    }

    bool has_calls() const override { return true; }

    bool repeat_last() override {
        const bool repeated = player_.repeat_last_frame();
        device_.check_failure();
        return repeated;
    }

private:
    static std::function<void(const trace::Call&)> pass_on(const FrameSourceOptions& options) {
        if (!options.on_call) return {};
        return
            [tell = options.on_call](const trace::Call& call) { tell(call.number(), call.name()); };
    }

    trace::TraceReader reader_;
    FailureKeeper device_;
    trace::TracePlayer player_;
};

class CaptureSource : public FrameSource {
public:
    CaptureSource(const std::string& path, Device& device)
        : reader_(path)
        , device_(device) {
        if (reader_.memory_size() > device.memory_size())
            throw InputError(path + ": needs a device with " +
                             std::to_string(reader_.memory_size()) + " bytes of memory");
    }

    std::uint64_t first_frame() const override { return reader_.first_frame(); }

    std::uint32_t prepare() override {
        reader_.play_snapshot(device_);
        return reader_.first_draw();
    }

    std::optional<Frame> next() override {
        const auto shown = reader_.play_frame(device_);
        if (!shown) {
            reader_.expect_frames();
            return std::nullopt;
        }
        return Frame{shown->frame, shown->picture, 0};
    }

private:
    capture::CaptureReader reader_;
    Device& device_;
};

} // namespace

void check_samples(unsigned samples, const gl::ControlPanel& panel) {
    if (samples > 1 && panel.supersampling > 1)
        throw InputError("--samples and gpu.supersampling: a window has one or the other");
}

std::unique_ptr<FrameSource>
open_frame_source(const std::string& path, Device& device, const FrameSourceOptions& options) {
    if (work::WorkFileReader::is_work_file(path))
        throw InputError(path + ": is a work file, which has no pictures and no commands to draw "
                                "them: ffgpu time, cache, export, sweep and info read it");
    const bool is_capture = capture::CaptureReader::is_capture(path);
    if (is_capture && options.samples > 1)
        throw InputError(path + ": is a capture, whose windows are as they were: --samples is for "
                                "traces");
    if (is_capture && options.swap != gl::SwapMode::Copy)
        throw InputError(path + ": is a capture, whose swaps are in it: --swap is for traces");
    if (is_capture && !(options.panel == gl::ControlPanel{}))
        throw InputError(path + ": is a capture, which no driver draws: gpu.texture_filter and "
                                "gpu.supersampling are for traces");
    if (is_capture) return std::make_unique<CaptureSource>(path, device);
    check_samples(options.samples, options.panel);
    return std::make_unique<TraceSource>(path, device, options);
}

} // namespace ffgpu::tools
