#include "tools/commands/commands.h"
#include "tools/dump/dump_capture.h"

#include <cstdio>
#include <memory>

#include <CLI/CLI.hpp>

namespace ffgpu::tools {

void add_dump_command(CLI::App& application, Run& run) {
    const auto options = std::make_shared<DumpOptions>();
    CLI::App* const verb = application.add_subcommand(
        "dump", "Prints a device capture as text: commands and registers by name");
    verb->add_option("capture", options->input, "A device capture (.ffc)")->required();
    verb->add_flag("--readmemh",
                   options->words,
                   "The words of the commands in hexadecimal, as Verilog's $readmemh reads them");
    verb->footer("Example: ffgpu dump corridor.ffc | grep draw");
    verb->callback([options, &run] {
        run = [options] {
            dump_capture(*options, [](std::string_view text) {
                std::fwrite(text.data(), 1, text.size(), stdout);
            });
            return 0;
        };
    });
}

} // namespace ffgpu::tools
