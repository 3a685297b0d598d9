#include "model/base/input_error.h"
#include "model/base/whole_file.h"
#include "tools/cache/cache_arguments.h"
#include "tools/cache/cache_report.h"
#include "tools/cache/curve_plots.h"
#include "tools/commands/commands.h"
#include "tools/commands/warn.h"
#include "tools/files/files_to_write.h"
#include "tools/record/output_folder.h"
#include "tools/replay/interruption.h"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include <CLI/CLI.hpp>

namespace ffgpu::tools {
namespace {

constexpr std::string_view MissMapPrefix = "miss_map";
constexpr std::array<std::string_view, 2> PicturePrefixes{MissMapPrefix, CurvePlotPrefix};

void write_file(const std::string& path, const std::string& text) {
    WholeFile file(path);
    file.write(text);
    file.commit();
}

void write_results(const CacheArguments& arguments,
                   const CacheStudyOptions& options,
                   const CacheStudyResult& result,
                   OutputFolder& folder) {
    if (std::fputs(cache_tables(options, result).c_str(), stdout) < 0 || std::fflush(stdout) != 0)
        throw InputError(std::string("standard output: cannot be written: ") +
                         std::strerror(errno));
    if (arguments.output.empty()) return;
    write_file(folder.file("curves.csv"), curves_csv(options, result));
    write_file(folder.file("working_sets.csv"), working_sets_csv(result));
    for (const NamedPlot& plot : curve_plots(options, result))
        write_file(folder.file(plot.file), plot.svg);
    if (const std::string older = folder.older_pictures(); !older.empty()) warn(older);
}

int run_cache(const CacheArguments& arguments) {
    CacheStudyOptions options = resolve(arguments);
    check_folder({options.input, arguments.config}, arguments.output);
    options.warn = warn;
    const Interruption interruption;
    OutputFolder folder(arguments.output, PicturePrefixes);
    options.on_miss_map = [&](std::uint64_t frame, const Image& map) {
        write_png(folder.picture(MissMapPrefix, frame), map);
    };
    CacheStudyResult result;
    try {
        study_caches(options, result);
    } catch (const InputError&) {
        if (!result.frames.empty())
            write_results(arguments, options, result, folder); // What is done.
        throw;
    }
    if (!result.frames.empty() || Interruption::signal() == 0)
        write_results(arguments, options, result, folder);
    return Interruption::status(0);
}

} // namespace

void add_cache_command(CLI::App& application, Run& run) {
    const auto arguments = std::make_shared<CacheArguments>();
    CLI::App* const verb = application.add_subcommand(
        "cache", "Miss-rate curves of all LRU caches from one pass over a trace or its work");
    add_cache_options(*verb, *arguments);
    verb->footer("Example: ffgpu cache traces/corridor.trace -o out/cache --layout linear,blocked "
                 "--order scanline,tiled:8");
    verb->callback([arguments, &run] { run = [arguments] { return run_cache(*arguments); }; });
}

} // namespace ffgpu::tools
