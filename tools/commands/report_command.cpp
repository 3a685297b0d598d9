#include "tools/commands/commands.h"
#include "tools/report_page/report_page.h"

#include <cstdio>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>

namespace ffgpu::tools {

void add_report_command(CLI::App& application, Run& run) {
    struct Arguments {
        ReportOptions report;
        std::string frames;
    };
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
    verb->add_option("--frames", arguments->frames, "Only these")->type_name("A-B");
    verb->footer("Example: ffgpu report out/corridor out/two_ways");
    verb->callback([arguments, &run] {
        run = [arguments] {
            if (!arguments->frames.empty())
                arguments->report.frames = parse_frame_range(arguments->frames);
            std::fputs(write_report(arguments->report).c_str(), stdout);
            return 0;
        };
    });
}

} // namespace ffgpu::tools
