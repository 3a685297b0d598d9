#include "model/base/input_error.h"
#include "tools/commands/commands.h"
#include "tools/commands/warn.h"
#include "tools/files/files_to_write.h"
#include "tools/record/recording_arguments.h"
#include "tools/replay/interruption.h"
#include "tools/replay/replay.h"
#include "tools/rtl/pipe_comparison.h"
#include "tools/rtl/rtl_comparison.h"
#include "tools/rtl/wave_range.h"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <memory>
#include <optional>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

struct Arguments {
    RecordingArguments recording;
    ReplayOptions replay;
    std::vector<std::string> rtl;
    std::string rtl_cycles;
    std::optional<unsigned> rtl_latency;
    std::string fst, fst_cycles;
};

// 1: what the units drew is not what the model draws.
int replay_and_compare(RtlDevice& comparison, ReplayOptions& options) {
    options.rtl = &comparison;
    std::fputs(replay(options).c_str(), stderr);
    if (options.frames.first > 0)
        fmt::print(stderr,
                   "rtl: of all that was drawn, in frames before {} as well:\n",
                   options.frames.first);
    std::fputs(comparison.summary().c_str(), stderr);
    comparison.commit();
    return comparison.equal() ? 0 : 1;
}

int replay_by_units(const Arguments& arguments,
                    const rtl::WaveCycles& wave_cycles,
                    ReplayOptions& options) {
    if (!arguments.rtl_cycles.empty())
        throw InputError("--rtl-cycles: only fragment_pipe has cycles of draws");
    if (arguments.rtl_latency) throw InputError("--rtl-latency: only fragment_pipe has a memory");
    RtlComparison comparison({.units = arguments.rtl,
                              .waves = arguments.fst,
                              .wave_cycles = wave_cycles,
                              .other_names = "fragment_pipe"});
    options.stages = &comparison.stages();
    return replay_and_compare(comparison, options);
}

int replay_by_rtl(const Arguments& arguments, ReplayOptions& options) {
    const std::vector<std::string>& units = arguments.rtl;
    const rtl::WaveCycles cycles = parse_wave_cycles(arguments.fst_cycles);
    if (std::ranges::find(units, "fragment_pipe") == units.end())
        return replay_by_units(arguments, cycles, options);
    if (units.size() != 1) throw InputError("--rtl: fragment_pipe has all units, and stands alone");
    PipeComparison comparison(
        {.latency = arguments.rtl_latency.value_or(rtl::PipeOptions{}.latency),
         .jitters = arguments.rtl_cycles.empty(),
         .waves = arguments.fst,
         .wave_cycles = cycles},
        arguments.rtl_cycles);
    return replay_and_compare(comparison, options);
}

int run_replay(Arguments& arguments) {
    ReplayOptions& options = arguments.replay;
    resolve(arguments.recording, options);
    check_files({options.input, arguments.recording.config},
                {{"--capture", arguments.recording.capture},
                 {"--save-work", arguments.recording.save_work},
                 {"--rtl-cycles", arguments.rtl_cycles}});
    check_folder({options.input, arguments.recording.config}, options.output);
    if (options.benchmark > 0) options.images = false;
    if (options.player_only && (options.benchmark == 0 || !options.output.empty() ||
                                !options.capture.empty() || !options.save_work.empty()))
        throw InputError("--player-only draws nothing: it goes with --benchmark N alone");
    options.warn = warn;
    warn_of_settings(settings_without_effect(arguments.recording));
    if (options.output.empty() && options.capture.empty() && options.save_work.empty() &&
        options.benchmark == 0 && arguments.rtl.empty())
        throw InputError(
            "replay: nothing to do: expected -o DIR, --capture FILE, --save-work FILE, "
            "--rtl UNIT or --benchmark N");
    const Interruption interruption;
    int status = 0;
    if (arguments.rtl.empty())
        std::fputs(replay(options).c_str(), stderr);
    else
        status = replay_by_rtl(arguments, options);
    return Interruption::status(status);
}

} // namespace

void add_replay_command(CLI::App& application, Run& run) {
    const auto arguments = std::make_shared<Arguments>();
    ReplayOptions& options = arguments->replay;
    CLI::App* const verb = application.add_subcommand(
        "replay", "Draws a trace of an OpenGL program, or a device capture (.ffc)");
    verb->add_option("input", options.input, "An apitrace file or a .ffc capture")->required();
    add_recording_options(*verb, arguments->recording);
    add_samples_option(*verb, options.samples);
    add_swap_option(*verb, options.swap);
    verb->add_option("--rtl", arguments->rtl, "Draw with Verilated units; compare each draw")
        ->type_name("UNIT[,UNIT]|all|fragment_pipe")
        ->delimiter(',');
    CLI::Option* const rtl = verb->get_option("--rtl");
    verb->add_option("--rtl-cycles", arguments->rtl_cycles, "Cycles of each draw in fragment_pipe")
        ->type_name("FILE.csv")
        ->needs(rtl);
    verb->add_option("--rtl-latency", arguments->rtl_latency, "Cycles of fragment_pipe's memory")
        ->check(CLI::Range(1u, 4096u))
        ->needs(rtl);
    verb->add_option("--fst", arguments->fst, "Waves of the units, for GTKWave: FOLDER/UNIT.fst")
        ->type_name("FOLDER")
        ->needs(rtl);
    verb->add_option("--fst-cycles", arguments->fst_cycles, "Of these cycles of each unit's alone")
        ->type_name("RANGE")
        ->needs(verb->get_option("--fst"));
    verb->add_option("--benchmark", options.benchmark, "Time it; repeat the last frame N times")
        ->check(CLI::Range(1u, std::numeric_limits<unsigned>::max()))
        ->type_name("N");
    verb->add_flag("--player-only", options.player_only, "With --benchmark: draw nothing");
    verb->add_flag("--verbose", options.report_errors, "Report each GL error with its call");
    verb->footer("Example: ffgpu replay traces/corridor.trace -o out --timing --heatmap overdraw");
    verb->callback([arguments, &run] { run = [arguments] { return run_replay(*arguments); }; });
}

} // namespace ffgpu::tools
