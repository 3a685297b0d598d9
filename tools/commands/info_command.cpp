#include "tools/commands/commands.h"
#include "tools/info/describe_file.h"

#include <cstdio>
#include <memory>

#include <CLI/CLI.hpp>

namespace ffgpu::tools {

void add_info_command(CLI::App& application, Run& run) {
    const auto file = std::make_shared<std::string>();
    CLI::App* const verb = application.add_subcommand(
        "info", "Tells what is in a trace, a device capture or a work file");
    verb->add_option("file", *file, "A trace, a capture (.ffc) or a work file (.ffw)")->required();
    verb->footer("Example: ffgpu info traces/corridor.trace");
    verb->callback([file, &run] {
        run = [file] {
            std::fputs(describe_file(*file).c_str(), stdout);
            return 0;
        };
    });
}

} // namespace ffgpu::tools
