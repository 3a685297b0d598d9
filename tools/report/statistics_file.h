// stats.json in a folder, which is made where it is missing.

#pragma once

#include "tools/report/statistics_report.h"

#include <string>

namespace ffgpu::tools {

// The first two throw InputError.
void make_folder(const std::string& path);
void write_statistics_file(const StatisticsReport& report, const std::string& folder);
// Of an older run, if there is one.
void remove_statistics_file(const std::string& folder);

} // namespace ffgpu::tools
