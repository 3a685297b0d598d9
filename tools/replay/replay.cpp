#include "tools/replay/replay.h"

#include "model/base/input_error.h"
#include "tools/frames/frame_source.h"
#include "tools/frames/progress.h"
#include "tools/record/recording.h"
#include "tools/replay/idle_device.h"
#include "tools/replay/interruption.h"

#include <chrono>
#include <memory>

#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

class Replay {
public:
    explicit Replay(const ReplayOptions& options)
        : options_(options)
        , recording_(options)
        , source_(open_frame_source(options.input,
                                    drawn_on(),
                                    {.warn = options.warn,
                                     .report_errors = options.report_errors,
                                     .keep_last = options.benchmark > 0,
                                     .samples = options.samples,
                                     .swap = options.swap,
                                     .panel = options.configuration.gpu.panel(),
                                     .on_call = call_listener()})) {
        if (source_->has_calls()) recording_.set_calls(&calls_);
    }

    std::string run() {
        try {
            play();
        } catch (const std::runtime_error&) {
            keep_what_is_done();
            throw;
        }
        recording_.finish();
        return recording_.summary() + benchmark_line_;
    }

private:
    // Each call of a trace is noted where draws are to be told of.
    std::function<void(std::uint64_t, std::string_view)> call_listener() {
        if (!options_.draw_table) return {};
        return [this](std::uint64_t number, std::string_view name) { calls_.begin(number, name); };
    }

    Device& drawn_on() {
        if (options_.player_only) return idle_;
        if (!options_.rtl) return recording_.device();
        options_.rtl->attach(recording_.device(), recording_.gpu());
        return *options_.rtl;
    }

    // What went wrong first is what is told.
    void keep_what_is_done() {
        try {
            recording_.finish();
        } catch (const std::runtime_error&) {
        }
        try {
            if (options_.rtl) options_.rtl->commit();
        } catch (const std::runtime_error&) {
        }
    }

    void play() {
        Progress progress(options_.frames.last < ~std::uint64_t{0}
                              ? std::optional(options_.frames.last)
                              : std::nullopt);
        std::uint64_t next = source_->first_frame();
        const std::uint32_t draw = source_->prepare();
        recording_.number_from(next, draw);
        if (options_.rtl) options_.rtl->number_draws_from(draw);
        do {
            recording_.before_frame(next);
            if (measured_ == 0) started_ = std::chrono::steady_clock::now();
            const std::optional<Frame> frame = source_->next();
            if (!frame) {
                check_range(next);
                break;
            }
            if (recording_.after_frame(*frame)) ++measured_;
            progress.show(frame->number);
            next = frame->number + 1;
        } while (next <= options_.frames.last && Interruption::signal() == 0);
        if (options_.benchmark > 0 && Interruption::signal() == 0) benchmark();
    }

    // The input ended, of which `frames` were played: were others asked for?
    void check_range(std::uint64_t frames) const {
        const std::string line = missing_frames(options_.frames, options_.input, frames);
        if (measured_ == 0 && options_.frames.first > 0) throw InputError(line);
        if (!line.empty()) options_.warn(line);
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
        recording_.gpu().finish();
        const double seconds = Seconds(now() - start).count();
        benchmark_line_ += fmt::format("{:.2f} frames/s, {:.3f} ms/frame over the last frame, {} "
                                       "times\n",
                                       options_.benchmark / seconds,
                                       1000 * seconds / options_.benchmark,
                                       options_.benchmark);
    }

    const ReplayOptions& options_;
    Recording recording_;
    IdleDevice idle_{recording_.device().memory_size()};
    CallLog calls_;
    std::unique_ptr<FrameSource> source_; // Plays on it.
    unsigned measured_ = 0;
    std::chrono::steady_clock::time_point started_{};
    std::string benchmark_line_;
};

} // namespace

std::string replay(const ReplayOptions& options) {
    return Replay(options).run();
}

} // namespace ffgpu::tools
