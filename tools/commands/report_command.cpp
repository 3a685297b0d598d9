#include "model/base/input_error.h"
#include "tools/commands/commands.h"
#include "tools/files/files_to_write.h"
#include "tools/report_page/report_page.h"
#include "tools/sweep/point_report.h"

#include <cstdio>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>

namespace ffgpu::tools {
namespace {

struct Arguments {
    ReportOptions report;
    std::string frames;
    std::string point, trace;
};

std::string report(Arguments& arguments) {
    ReportOptions& options = arguments.report;
    if (!arguments.frames.empty()) options.frames = parse_frame_range(arguments.frames);
    for (const std::string& folder : {options.folder, options.other})
        check_outside("-o", options.output, folder);
    if (arguments.point.empty()) {
        if (!arguments.trace.empty()) throw InputError("report: --trace is of --point");
        return write_report(options);
    }
    if (!options.other.empty() || !arguments.frames.empty())
        throw InputError("report --point: expected a sweep's folder alone, and no --frames");
    return report_point({.sweep = options.folder,
                         .point = arguments.point,
                         .trace = arguments.trace,
                         .output = options.output});
}

} // namespace

void add_report_command(CLI::App& application, Run& run) {
    const auto arguments = std::make_shared<Arguments>();
    ReportOptions& options = arguments->report;
    CLI::App* const verb = application.add_subcommand(
        "report", "One page of a run: frames, draws, units, caches, memory; or of two, compared");
    verb->add_option("folder", options.folder, "What replay, run or time wrote with --timing")
        ->type_name("DIR")
        ->required();
    verb->add_option("other", options.other, "The same work with another configuration")
        ->type_name("DIR");
    verb->add_option("-o,--output", options.output, "The page; report.html in the folder")
        ->type_name("PAGE.html");
    verb->add_option("--frames", arguments->frames, "Only these")
        ->type_name("A-B")
        ->each(check_frame_range);
    verb->add_option("--point", arguments->point, "Of a sweep's folder: this point, run once more")
        ->type_name("POINT");
    verb->add_option("--trace", arguments->trace, "With --point: of which trace")
        ->type_name("NAME");
    verb->footer("Example: ffgpu report out/corridor out/two_ways");
    verb->callback([arguments, &run] {
        run = [arguments] {
            std::fputs(report(*arguments).c_str(), stdout);
            return 0;
        };
    });
}

} // namespace ffgpu::tools
