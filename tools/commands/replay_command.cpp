#include "model/base/input_error.h"
#include "tools/commands/commands.h"
#include "tools/config/config_file.h"
#include "tools/replay/replay.h"

#include <cstdio>
#include <memory>
#include <optional>

#include <CLI/CLI.hpp>

namespace ffgpu::tools {
namespace {

struct Arguments {
    std::string frames, heat_maps, config;
    std::vector<std::string> settings;
    std::optional<std::uint32_t> threads;
    bool no_images = false;
    ReplayOptions replay;
};

int run_replay(Arguments& arguments) {
    ReplayOptions& options = arguments.replay;
    Configuration& configuration = options.configuration;
    if (!arguments.config.empty()) read_config_file(arguments.config, configuration);
    for (const std::string& setting : arguments.settings)
        apply_setting(setting, configuration);
    if (arguments.threads)
        apply_setting("gpu.threads=" + std::to_string(*arguments.threads), configuration);
    if (!arguments.frames.empty()) options.frames = parse_frame_range(arguments.frames);
    if (!arguments.heat_maps.empty()) options.heat_maps = parse_heat_maps(arguments.heat_maps);
    options.images = !arguments.no_images && options.benchmark == 0;
    options.warn = [](const std::string& line) {
        std::fprintf(stderr, "ffgpu: warning: %s\n", line.c_str());
    };
    if (options.output.empty() && options.capture.empty() && options.benchmark == 0)
        throw InputError("replay: nothing to do: expected -o DIR, --capture FILE or --benchmark N");
    std::fputs(replay(options).c_str(), stderr);
    return 0;
}

} // namespace

void add_replay_command(CLI::App& application, Run& run) {
    const auto arguments = std::make_shared<Arguments>();
    ReplayOptions& options = arguments->replay;
    CLI::App* const verb = application.add_subcommand(
        "replay", "Draws a trace of an OpenGL program, or a device capture (.ffc)");
    verb->add_option("input", options.input, "An apitrace file or a .ffc capture")->required();
    verb->add_option("-o,--output", options.output, "Folder for frame_0000.png ..., stats.json")
        ->type_name("DIR");
    verb->add_option("--frames", arguments->frames, "Write and measure only these frames")
        ->type_name("A-B");
    verb->add_option("--config", arguments->config, "Parameters; ffgpu config prints them")
        ->type_name("F.toml");
    verb->add_option("--set", arguments->settings, "Change a parameter: texel_cache.ways=8")
        ->type_name("NAME=VALUE");
    verb->add_option("--threads", arguments->threads, "Threads that draw (gpu.threads)")
        ->type_name("N");
    verb->add_flag("--timing", options.timing, "Run the timing model: cycles, caches, memory");
    verb->add_option("--heatmap", arguments->heat_maps, "overdraw,level,texture_misses,cycles")
        ->type_name("MAP[,MAP]");
    verb->add_option("--capture", options.capture, "Write the frames as a device capture")
        ->type_name("FILE.ffc");
    verb->add_flag("--no-images", arguments->no_images, "Write no frame_*.png");
    verb->add_option("--benchmark", options.benchmark, "Time it; repeat the last frame N times")
        ->type_name("N");
    verb->add_flag("--verbose", options.report_errors, "Report each GL error with its call");
    verb->footer("Example: ffgpu replay traces/corridor.trace -o out --timing --heatmap overdraw");
    verb->callback([arguments, &run] { run = [arguments] { return run_replay(*arguments); }; });
}

} // namespace ffgpu::tools
