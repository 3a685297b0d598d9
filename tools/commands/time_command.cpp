#include "model/base/input_error.h"
#include "tools/commands/commands.h"
#include "tools/commands/warn.h"
#include "tools/config/config_file.h"
#include "tools/config/settings_option.h"
#include "tools/files/files_to_write.h"
#include "tools/replay/interruption.h"
#include "tools/time/time_work.h"
#include "tools/work/work_player.h"

#include <cstdio>
#include <memory>
#include <vector>

#include <CLI/CLI.hpp>

namespace ffgpu::tools {

void add_time_command(CLI::App& application, Run& run) {
    struct Arguments {
        TimeOptions time;
        std::string config;
        std::vector<std::string> settings;
    };
    const auto arguments = std::make_shared<Arguments>();
    CLI::App* const verb = application.add_subcommand(
        "time", "Runs the timing model on work that replay or run kept with --save-work");
    verb->add_option("work", arguments->time.input, "A work file (.ffw)")->required();
    verb->add_option("-o,--output", arguments->time.output, "Folder for stats.json")
        ->type_name("DIR");
    verb->add_option("--totals", arguments->time.totals, "Only the sums over all frames, as JSON")
        ->type_name("FILE");
    verb->add_flag("--measure-gains",
                   arguments->time.measure_gains,
                   "gains.csv: cycles without the limits of each resource, from a run for each");
    verb->add_option("--config", arguments->config, "Parameters; ffgpu config prints them")
        ->type_name("F.toml|preset:NAME");
    add_settings_option(*verb, arguments->settings);
    verb->footer("Example: ffgpu time corridor.ffw -o out/two_ways --set texel_cache.ways=2");
    verb->callback([arguments, &run] {
        run = [arguments] {
            if (arguments->time.output.empty() && arguments->time.totals.empty())
                throw InputError("time: nothing to do: expected -o DIR or --totals FILE");
            if (arguments->time.measure_gains && arguments->time.output.empty())
                throw InputError("time: --measure-gains writes gains.csv: expected -o DIR");
            check_files({arguments->time.input, arguments->config},
                        {{"--totals", arguments->time.totals}});
            check_folder({arguments->time.input, arguments->config}, arguments->time.output);
            check_outside("--totals", arguments->time.totals, arguments->time.output);
            Configuration& configuration = arguments->time.configuration;
            if (!arguments->config.empty()) read_config_file(arguments->config, configuration);
            for (const std::string& setting : arguments->settings)
                apply_setting(setting, configuration);
            if (configuration.gpu.forces()) warn(forces_nothing(arguments->time.input));
            const Interruption interruption;
            std::fputs(time_work(arguments->time).c_str(), stderr);
            return Interruption::status(0);
        };
    });
}

} // namespace ffgpu::tools
