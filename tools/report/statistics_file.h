// stats.json in a folder, which is made where it is missing.

#pragma once

#include "tools/report/statistics_report.h"

#include <string>

namespace ffgpu::tools {

// The first two throw InputError.
void make_folder(const std::string& path);
void write_statistics_file(const StatisticsReport& report, const std::string& folder);
// The sums alone, of all frames, or of those before the machine was stuck. Without a path nothing
// is written.
void write_totals_file(const StatisticsReport& report, const std::string& path, bool is_stuck);
// Of an older run, if there is one.
void remove_statistics_files(const std::string& folder);

} // namespace ffgpu::tools
