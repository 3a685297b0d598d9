#include "model/timing/machine_checks.h"
#include "tools/commands/commands.h"
#include "tools/config/config_file.h"
#include "tools/config/settings_option.h"

#include <cstdio>
#include <memory>

#include <CLI/CLI.hpp>

namespace ffgpu::tools {

void add_config_command(CLI::App& application, Run& run) {
    struct Options {
        std::string file;
        std::vector<std::string> settings;
    };
    const auto options = std::make_shared<Options>();
    CLI::App* const verb = application.add_subcommand(
        "config", "Prints the configuration as TOML, each parameter with unit, range and meaning");
    verb->add_option("--config", options->file, "Start from this file instead of the defaults")
        ->type_name("F.toml|preset:NAME");
    add_settings_option(*verb, options->settings);
    verb->footer("Example: ffgpu config > my.toml");
    verb->callback([options, &run] {
        run = [options] {
            Configuration configuration;
            if (!options->file.empty()) read_config_file(options->file, configuration);
            for (const std::string& setting : options->settings)
                apply_setting(setting, configuration);
            timing::check_machine(configuration.timing);
            std::fputs(to_toml(configuration).c_str(), stdout);
            return 0;
        };
    });
}

} // namespace ffgpu::tools
