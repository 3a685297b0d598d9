#include "model/base/input_error.h"
#include "tools/cache/cache_arguments.h"
#include "tools/commands/commands.h"
#include "tools/commands/warn.h"
#include "tools/config/config_file.h"
#include "tools/export/export.h"
#include "tools/files/files_to_write.h"
#include "tools/replay/interruption.h"

#include <bit>
#include <cstdio>
#include <memory>
#include <optional>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

struct Arguments {
    ExportOptions options;
    std::string format, frames, config;
    std::optional<std::string> client;
    std::optional<std::uint32_t> access_bytes;
    std::vector<std::string> settings;
};

int run_export(Arguments& arguments) {
    ExportOptions& options = arguments.options;
    options.format = parse_export_format(arguments.format);
    if (arguments.client) options.client = parse_client("--client", *arguments.client);
    if (arguments.access_bytes) options.access_bytes = *arguments.access_bytes;
    if (!arguments.config.empty()) read_config_file(arguments.config, options.configuration);
    for (const std::string& setting : arguments.settings)
        apply_setting(setting, options.configuration);
    if (!arguments.frames.empty()) options.frames = parse_frame_range(arguments.frames);
    if (!std::has_single_bit(options.access_bytes) || options.access_bytes > 512)
        throw InputError(fmt::format("--access-bytes {}: expected a power of two up to 512",
                                     options.access_bytes));
    check_files({options.input, arguments.config}, {{"-o", options.output}});
    options.warn = warn;
    const auto warn_of = [&](const char* option) {
        warn(fmt::format("{}: has no effect with --format {}", option, arguments.format));
    };
    if (arguments.client && !has_client(options.format)) warn_of("--client");
    if (arguments.access_bytes && !has_access_bytes(options.format)) warn_of("--access-bytes");
    const Interruption interruption;
    std::fputs(export_trace(options).c_str(), stderr);
    return Interruption::status(0);
}

} // namespace

void add_export_command(CLI::App& application, Run& run) {
    const auto arguments = std::make_shared<Arguments>();
    ExportOptions& options = arguments->options;
    CLI::App* const verb = application.add_subcommand(
        "export", "Memory traces and timelines of a trace or its work, for other tools");
    verb->add_option("input", options.input, "A trace, a .ffc capture or a work file (.ffw)")
        ->required();
    verb->add_option("--format", arguments->format, "din, dramsim3, csv ...: docs/export.md")
        ->type_name("FORMAT")
        ->required();
    verb->add_option("-o,--output", options.output, "A file; - or nothing: standard output")
        ->type_name("FILE");
    verb->add_flag("--zstd", options.compresses, "Compressed, with Zstandard");
    verb->add_option(
            "--client", arguments->client, "din, xdin: texel (default), depth, color, vertex")
        ->type_name("CLIENT");
    verb->add_option("--access-bytes",
                     arguments->access_bytes,
                     "Of a record of ramulator2 and dramsim3, which tell no sizes (default 64)")
        ->type_name("BYTES");
    verb->add_option("--frames", arguments->frames, "Only these frames of a trace")
        ->type_name("A-B")
        ->each(check_frame_range);
    verb->add_option("--config", arguments->config, "Parameters; ffgpu config prints them")
        ->type_name("F.toml|preset:NAME");
    verb->add_option("--set", arguments->settings, "Change a parameter: texel_cache.ways=8")
        ->type_name("NAME=VALUE")
        ->allow_extra_args(false);
    verb->footer("Example: ffgpu export traces/corridor.trace --format dramsim3 -o corridor.trc");
    verb->callback([arguments, &run] { run = [arguments] { return run_export(*arguments); }; });
}

} // namespace ffgpu::tools
