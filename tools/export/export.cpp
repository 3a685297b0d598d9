#include "tools/export/export.h"

#include "model/base/input_error.h"
#include "model/timing/gpu_timing.h"
#include "model/work/lookup_walk.h"
#include "tools/cache/not_followed.h"
#include "tools/config/nearest_name.h"
#include "tools/export/command_trace.h"
#include "tools/export/din_writer.h"
#include "tools/export/memory_trace.h"
#include "tools/export/timeline_trace.h"
#include "tools/replay/interruption.h"
#include "tools/work/work_player.h"

#include <algorithm>
#include <exception>
#include <span>

namespace ffgpu::tools {
namespace {

WorkPlayOptions play_options(const ExportOptions& options) {
    return {.input = options.input,
            .frames = options.frames,
            .ends_behind = options.ends_behind,
            .gpu = options.configuration.gpu,
            .machine = options.configuration.timing,
            .warn = options.warn};
}

// Work came behind the input's last frame, and is in the output, which has not its name.
struct CameBehindFrames {
    std::uint64_t last_frame = 0;
};

// Plays the work, then completes the output; a fault of the input comes after that, and an
// Interruption is the input's end.
template <class Finish>
void play_and_finish(const ExportOptions& options,
                     bool can_begin_anew,
                     work::CommandSink& sink,
                     const std::function<void(const work::FrameFigures&)>& frame,
                     Finish&& finish) {
    std::uint64_t frames = 0, last_frame = 0;
    const auto counting = [&](const work::FrameFigures& figures) {
        frame(figures);
        ++frames;
        last_frame = figures.number;
    };
    std::exception_ptr fault;
    try {
        const bool has_more = play_work(play_options(options), sink, counting);
        if (has_more && frames == 0) throw InputError(options.input + ": has no whole frame");
        if (has_more && can_begin_anew) throw CameBehindFrames{last_frame};
    } catch (const InputError&) {
        if (frames == 0) throw;
        fault = std::current_exception();
    }
    if (frames == 0 && Interruption::signal() != 0) return; // There is nothing to keep.
    finish();
    if (fault) std::rethrow_exception(fault);
}

std::uint32_t line_bytes_of(const timing::TimingConfig& timing, work::LookupClient client) {
    switch (client) {
    case work::LookupClient::Texel:
        return timing.texel_cache.line_bytes;
    case work::LookupClient::Depth:
        return timing.depth_cache.line_bytes;
    case work::LookupClient::Color:
        return timing.color_cache.line_bytes;
    case work::LookupClient::Vertex:
        break;
    }
    return timing.vertex.line_bytes;
}

// --- Look-ups ------------------------------------------------------------------------------------

std::string export_lookups(const ExportOptions& options) {
    const timing::TimingConfig& timing = options.configuration.timing;
    ExportOutput output(options.output, options.compresses);
    TextWriter text(output);
    const auto form =
        options.format == ExportFormat::Din ? DinWriter::Form::Din : DinWriter::Form::Extended;
    const std::uint32_t line_bytes = line_bytes_of(timing, options.client);
    DinWriter writer(form, options.client, line_bytes, text);
    for (const std::string& line : not_followed_by_lookups(timing, std::span(&options.client, 1)))
        options.warn(line);
    work::LookupWalk walk(timing.work(),
                          {.line_bytes = timing.vertex.line_bytes,
                           .reuse_entries = timing.vertex.reuse_entries,
                           .reuse_lru = timing.vertex.reuse_policy == timing::ReusePolicy::Lru},
                          writer);
    work::MachineOrder order(timing.work(), walk);
    play_and_finish(
        options,
        output.is_file(),
        order,
        [](const work::FrameFigures&) {},
        [&] {
            text.flush();
            output.commit();
        });
    return fmt::format("{} look-ups of lines of {} bytes\n", writer.written(), line_bytes);
}

// --- Memory --------------------------------------------------------------------------------------

MemoryTraceKind trace_kind(ExportFormat format) {
    switch (format) {
    case ExportFormat::Ramulator2:
        return MemoryTraceKind::Ramulator2;
    case ExportFormat::Ramulator2Vectors:
        return MemoryTraceKind::Ramulator2Vectors;
    case ExportFormat::Dramsim3:
        return MemoryTraceKind::Dramsim3;
    case ExportFormat::Dramsys:
        return MemoryTraceKind::Dramsys;
    default:
        return MemoryTraceKind::Csv;
    }
}

class NoMachine final : public work::MachineSink {
public:
    void scene(work::PreparedScene&&) override {}
    void transfer(work::PreparedTransfer&&) override {}
    void host_transfer(const HostTransfer&) override {}
    void end_frame(std::uint32_t) override {}
};

// An export has no figures of bottlenecks, whose reckoning is a third of the machine's time.
timing::TimingConfig without_bottlenecks(timing::TimingConfig config) {
    config.bottlenecks.enable = false;
    return config;
}

// The machine in time; where textures are asked for, their places, before it knows them.
class TracedMachine final : public work::CommandSink {
public:
    TracedMachine(const timing::TimingConfig& config, bool with_places)
        : with_places_(with_places)
        , order_(config.work(), no_machine_)
        , timing_(config) {
        timing_.let_frames_overlap();
    }

    void command(std::shared_ptr<const work::WholeCommand> command) override {
        if (with_places_) {
            order_.command(command);
            places_.add(*command, order_);
        }
        timing_.command(std::move(command));
    }
    void content(const std::shared_ptr<const SurfaceContent>& content) override {
        if (with_places_) order_.content(content);
        timing_.content(content);
    }
    void host_transfer(const HostTransfer& transfer) override {
        if (with_places_) order_.host_transfer(transfer);
        timing_.host_transfer(transfer);
    }
    void end_frame(std::uint32_t frame) override {
        if (with_places_) order_.end_frame(frame);
        timing_.end_frame(frame);
    }

    // All that was told has gone through it.
    void finish() { timing_.catch_up(); }

    // Declared behind what listens to the machine: its end waits until the machine stands, also
    // where an export ends early.
    class StandsAtEnd {
    public:
        explicit StandsAtEnd(TracedMachine& machine)
            : machine_(machine) {}
        StandsAtEnd(const StandsAtEnd&) = delete;
        StandsAtEnd& operator=(const StandsAtEnd&) = delete;
        ~StandsAtEnd() {
            try {
                machine_.finish();
            } catch (...) { // What went wrong was told.
            }
        }

    private:
        TracedMachine& machine_;
    };

    timing::GpuTiming& timing() { return timing_; }
    const TexturePlaces& places() const { return places_; }

private:
    const bool with_places_;
    NoMachine no_machine_;
    work::MachineOrder order_;
    TexturePlaces places_;
    timing::GpuTiming timing_;
};

std::string traffic_text(const TrafficByClient& traffic) {
    std::string text;
    for (std::size_t i = 0; i < traffic.size(); ++i)
        if (traffic[i].requests > 0)
            text += fmt::format("{:>10}: {} requests, {} bytes read, {} written\n",
                                timing::ClientNames[i],
                                traffic[i].requests,
                                traffic[i].read_bytes,
                                traffic[i].written_bytes);
    return text;
}

std::string export_memory(const ExportOptions& options) {
    const timing::TimingConfig config = without_bottlenecks(options.configuration.timing);
    ExportOutput output(options.output, options.compresses);
    TextWriter text(output);
    const bool names_quads = options.format == ExportFormat::Csv;
    TracedMachine machine(config, names_quads);
    MemoryTrace trace(make_memory_format(trace_kind(options.format),
                                         {.memory = config.memory,
                                          .access_bytes = options.access_bytes,
                                          .tile_width = config.raster.tile_width}),
                      config.texel_cache.line_bytes,
                      machine.places(),
                      text);
    machine.timing().leave_out_figures();
    machine.timing().set_memory_observer(&trace);
    // What misses in a first level need not come to memory.
    if (names_quads && !config.texel_l2.enable) machine.timing().set_quad_observer(&trace);
    machine.timing().set_on_frame([&](const timing::FrameTiming&) { trace.end_frame(); });
    const TracedMachine::StandsAtEnd stands(machine);
    play_and_finish(
        options,
        output.is_file(),
        machine,
        [&](const work::FrameFigures&) { trace.check_failure(); },
        [&] {
            machine.finish();
            trace.finish();
            output.commit();
        });
    return traffic_text(trace.traffic());
}

// --- DRAM commands -------------------------------------------------------------------------------

std::string commands_text(const CommandTrace::Counts& counts) {
    std::string text;
    for (std::size_t i = 0; i < counts.size(); ++i)
        if (counts[i] > 0)
            text += fmt::format("{:>5}: {}\n", timing::DramOperationNames[i], counts[i]);
    return text;
}

std::string export_commands(const ExportOptions& options) {
    const timing::TimingConfig config = without_bottlenecks(options.configuration.timing);
    if (config.memory.kind != timing::MemoryKind::Dram)
        throw InputError("--format dram_commands: expected memory.kind dram, found fixed");
    ExportOutput output(options.output, options.compresses);
    TextWriter text(output);
    TracedMachine machine(config, false);
    CommandTrace trace(config.memory, text);
    machine.timing().leave_out_figures();
    machine.timing().set_command_observer(&trace);
    const TracedMachine::StandsAtEnd stands(machine);
    play_and_finish(
        options,
        output.is_file(),
        machine,
        [&](const work::FrameFigures&) { trace.check_failure(); },
        [&] {
            machine.finish();
            trace.finish();
            output.commit();
        });
    return commands_text(trace.counts());
}

// --- Time ----------------------------------------------------------------------------------------

std::unique_ptr<TimelineFormat> make_timeline(const ExportOptions& options, TextWriter& text) {
    if (options.format == ExportFormat::Perfetto) return make_perfetto(text);
    if (options.format == ExportFormat::Vcd) return make_vcd(text);
    if (options.compresses) throw InputError("--zstd: fst is compressed as it is");
    return make_fst(options.output);
}

std::string export_time(const ExportOptions& options) {
    // FST has a writer of its own.
    const bool fst = options.format == ExportFormat::Fst;
    ExportOutput output(fst ? "/dev/null" : options.output, options.compresses);
    TextWriter text(output);
    const std::unique_ptr<TimelineFormat> format = make_timeline(options, text);
    timing::TimingConfig config = without_bottlenecks(options.configuration.timing);
    const bool tells_queues = options.format == ExportFormat::Perfetto;
    if (tells_queues) config.series.interval_cycles = TimelineTrace::Interval;
    TracedMachine machine(config, false);
    timing::GpuTiming& timing = machine.timing();
    TimelineTrace trace(*format, timing.unit_names());
    if (tells_queues)
        timing.set_series_sink(&trace);
    else
        timing.leave_out_figures();
    timing.set_activity_observer(&trace);
    timing.set_memory_observer(&trace);
    timing.set_on_frame([&](const timing::FrameTiming& frame) { trace.frame(frame); });
    const TracedMachine::StandsAtEnd stands(machine);
    play_and_finish(
        options,
        fst || output.is_file(),
        machine,
        [&](const work::FrameFigures&) { trace.check_failure(); },
        [&] {
            machine.finish();
            trace.finish(timing.cycles());
            text.flush();
            output.commit();
        });
    return fmt::format("{} units over {} cycles\n", timing.unit_names().size(), timing.cycles());
}

std::string export_once(const ExportOptions& options) {
    switch (options.format) {
    case ExportFormat::Din:
    case ExportFormat::Xdin:
        return export_lookups(options);
    case ExportFormat::DramCommands:
        return export_commands(options);
    case ExportFormat::Perfetto:
    case ExportFormat::Vcd:
    case ExportFormat::Fst:
        return export_time(options);
    default:
        return export_memory(options);
    }
}

} // namespace

ExportFormat parse_export_format(const std::string& name) {
    const auto found = std::find(ExportFormatNames.begin(), ExportFormatNames.end(), name);
    if (found == ExportFormatNames.end())
        throw InputError(
            fmt::format("--format {}: expected {}; did you mean '{}'?",
                        name,
                        fmt::join(ExportFormatNames, ", "),
                        nearest_name(name, {ExportFormatNames.begin(), ExportFormatNames.end()})));
    return static_cast<ExportFormat>(found - ExportFormatNames.begin());
}

bool has_client(ExportFormat format) {
    return format == ExportFormat::Din || format == ExportFormat::Xdin;
}

bool has_access_bytes(ExportFormat format) {
    return format == ExportFormat::Ramulator2 || format == ExportFormat::Ramulator2Vectors ||
           format == ExportFormat::Dramsim3;
}

std::string export_trace(const ExportOptions& options) {
    try {
        return export_once(options);
    } catch (const CameBehindFrames& came) {
        ExportOptions whole_frames = options;
        whole_frames.ends_behind = came.last_frame;
        whole_frames.warn = [](const std::string&) {}; // It was told.
        return export_once(whole_frames);
    }
}

} // namespace ffgpu::tools
