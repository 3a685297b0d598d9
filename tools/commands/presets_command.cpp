#include "tools/commands/commands.h"
#include "tools/config/preset.h"

#include <cstdio>
#include <memory>

#include <CLI/CLI.hpp>

namespace ffgpu::tools {

void add_presets_command(CLI::App& application, Run& run) {
    const auto page = std::make_shared<bool>(false);
    CLI::App* const verb =
        application.add_subcommand("presets", "Lists the machines that --config preset:NAME knows");
    verb->add_flag("--page", *page, "Every parameter of them with its source: docs/presets.md");
    verb->footer("Example: ffgpu config --config preset:geforce2_gts");
    verb->callback([page, &run] {
        run = [page] {
            std::fputs((*page ? presets_page() : list_presets()).c_str(), stdout);
            return 0;
        };
    });
}

} // namespace ffgpu::tools
