#include "tools/work/work_player.h"

#include "model/base/input_error.h"
#include "model/gpu/functional_gpu.h"
#include "model/timing/target_blocks.h"
#include "model/work/command_assembler.h"
#include "model/work/sink_thread.h"
#include "model/work/work_file_reader.h"
#include "tools/frames/frame_source.h"
#include "tools/frames/progress.h"
#include "tools/replay/interruption.h"

#include <algorithm>
#include <thread>

#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

using OnFrame = std::function<void(const work::FrameFigures&)>;

// What a pool does takes longer than to draw, which takes the processors that it leaves.
FunctionalGpu::Config gpu_config(const WorkPlayOptions& options) {
    const unsigned processors = std::max(1u, std::thread::hardware_concurrency());
    FunctionalGpu::Config config{.threads = options.gpu.threads,
                                 .tile_size = options.gpu.tile_size,
                                 .colors = options.colors};
    if (config.threads > 0) return config;
    config.threads = processors;
    if (!options.pool) return config;
    if (processors > options.pool->threads() + 1)
        config.threads = processors - options.pool->threads();
    else
        config.may_share = [pool = options.pool] { return !pool->has_jobs(); };
    return config;
}

// Sees what comes behind the last end of a frame.
class LastFrameWatch final : public WorkSink {
public:
    explicit LastFrameWatch(WorkSink& out)
        : out_(out) {}

    void bin(std::shared_ptr<const WorkBin> bin) override {
        has_more_ |= !bin->draws.empty() || !bin->transfers.empty();
        out_.bin(std::move(bin));
    }
    void end_frame(std::uint32_t frame) override {
        has_more_ = false;
        out_.end_frame(frame);
    }
    bool has_more() const { return has_more_; }

private:
    WorkSink& out_;
    bool has_more_ = false;
};

// Draws, and hands the work over on a thread of its own.
class Drawing {
public:
    Drawing(const WorkPlayOptions& options, WorkSink& sink, const OnFrame& on_frame)
        : options_(options)
        , on_frame_(on_frame)
        , gpu_(gpu_config(options))
        , watch_(sink)
        , thread_(watch_, options.pool)
        , source_(open_frame_source(
              options.input, gpu_, {.warn = options.warn, .panel = options.gpu.panel()})) {}

    // Whether work came behind the last frame.
    bool run() {
        try {
            play();
        } catch (const InputError&) {
            finish(); // What was drawn is handed over.
            throw;
        }
        finish();
        return watch_.has_more();
    }

private:
    void play() {
        Progress progress(std::nullopt);
        next_ = source_->first_frame();
        gpu_.number_from(static_cast<std::uint32_t>(next_), source_->prepare());
        while (next_ <= std::min(options_.frames.last, options_.ends_behind) && !is_interrupted()) {
            if (!recording_ && next_ >= options_.frames.first) {
                const bool values = !options_.machine.needs_values().empty();
                gpu_.set_work_sink(&thread_, values ? WorkDetail::Values : WorkDetail::Masks);
                recording_ = true;
            }
            const std::optional<Frame> frame = source_->next();
            if (!frame) return check_range();
            next_ = frame->number + 1;
            if (recording_) hand_over(*frame);
            progress.show(frame->number);
        }
        if (!recording_ && !is_interrupted())
            throw InputError(fmt::format("--frames: {} begins with frame {}: none of those asked "
                                         "for is there",
                                         options_.input,
                                         next_));
    }

    // The input ended: were other frames asked for?
    void check_range() const {
        const std::string line = missing_frames(options_.frames, options_.input, next_);
        if (next_ <= options_.frames.first && options_.frames.first > 0) throw InputError(line);
        if (!line.empty()) options_.warn(line);
    }
    bool is_interrupted() const {
        return Interruption::signal() != 0 && next_ >= options_.at_least;
    }

    void hand_over(const Frame& frame) {
        gpu_.finish();
        if (gpu_.missed_colors()) throw MissedColors{next_};
        thread_.check_failure();
        const work::FrameFigures figures{.number = frame.number,
                                         .width = frame.picture.width,
                                         .height = frame.picture.height,
                                         .api_calls = frame.api_calls,
                                         .functional = {}};
        thread_.post([this, figures] { on_frame_(figures); });
    }

    void finish() {
        gpu_.finish();
        thread_.drain();
        if (gpu_.missed_colors()) throw MissedColors{next_};
    }

    const WorkPlayOptions& options_;
    const OnFrame& on_frame_;
    FunctionalGpu gpu_;
    LastFrameWatch watch_;
    work::SinkThread thread_;
    std::unique_ptr<FrameSource> source_; // Plays on the GPU.
    std::uint64_t next_ = 0;              // frame
    bool recording_ = false;
};

// A file's work as the machine in time takes it: refused where values that it needs are missing;
// values that it does not need move nothing.
class WorkOfMachine final : public work::CommandSink {
public:
    WorkOfMachine(const timing::TimingConfig& machine, work::CommandSink& out)
        : machine_(machine)
        , out_(out) {}

    void command(std::shared_ptr<const work::WholeCommand> command) override {
        timing::check_values(machine_, *command, contents_told_);
        has_more_ = true;
        out_.command(std::move(command));
    }
    void content(const std::shared_ptr<const SurfaceContent>& content) override {
        contents_told_ = true;
        if (!machine_.needs_values().empty()) out_.content(content);
    }
    void host_transfer(const HostTransfer& transfer) override {
        has_more_ = true;
        out_.host_transfer(transfer);
    }
    void end_frame(std::uint32_t frame) override {
        has_more_ = false;
        out_.end_frame(frame);
    }
    bool has_more() const { return has_more_; } // behind the last frame

private:
    const timing::TimingConfig& machine_;
    work::CommandSink& out_;
    bool contents_told_ = false, has_more_ = false;
};

bool play_file(const WorkPlayOptions& options, work::CommandSink& sink, const OnFrame& on_frame) {
    if (!(options.frames == FrameRange{}))
        throw InputError("--frames: a work file is played whole: " + options.input);
    if (options.gpu.forces()) options.warn(forces_nothing(options.input));
    work::WorkFileReader file(options.input);
    Progress progress(std::nullopt);
    WorkOfMachine of_machine(options.machine, sink);
    file.play(of_machine, [&](const work::FrameFigures& figures) {
        on_frame(figures);
        progress.show(figures.number);
        if (Interruption::signal() != 0 || figures.number >= options.ends_behind) file.stop();
    });
    return of_machine.has_more();
}

} // namespace

std::string forces_nothing(const std::string& path) {
    return path + ": is work that was drawn: gpu.texture_filter and gpu.supersampling decide "
                  "nothing any more";
}

bool play_work(const WorkPlayOptions& options, work::CommandSink& sink, const OnFrame& frame) {
    if (work::WorkFileReader::is_work_file(options.input)) return play_file(options, sink, frame);
    work::CommandAssembler assembler(sink);
    return Drawing(options, assembler, frame).run();
}

bool play_work(const WorkPlayOptions& options, DrawReader& reader, const OnFrame& frame) {
    if (work::WorkFileReader::is_work_file(options.input)) return play_file(options, reader, frame);
    work::DrawSplitter splitter(reader);
    return Drawing(options, splitter, frame).run();
}

} // namespace ffgpu::tools
