// The verbs of the command line. Each adds itself with its options and an example to the
// application, and sets `run`, which main() calls: it returns the exit status.

#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace ffgpu::tools {

using Run = std::function<int()>;

void add_replay_command(CLI::App& application, Run& run);
void add_report_command(CLI::App& application, Run& run);
void add_time_command(CLI::App& application, Run& run);
void add_run_command(CLI::App& application, Run& run);
void add_cache_command(CLI::App& application, Run& run);
void add_compare_command(CLI::App& application, Run& run);
void add_config_command(CLI::App& application, Run& run);
void add_diff_command(CLI::App& application, Run& run);
void add_info_command(CLI::App& application, Run& run);
void add_dump_command(CLI::App& application, Run& run);
void add_explain_command(CLI::App& application, Run& run);
void add_export_command(CLI::App& application, Run& run);
void add_completion_command(CLI::App& application, Run& run);
void add_manual_command(CLI::App& application, Run& run);
void add_check_command(CLI::App& application, Run& run);
void add_presets_command(CLI::App& application, Run& run);

} // namespace ffgpu::tools
