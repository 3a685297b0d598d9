// What the page holds of a run, as JSON for its scripts. web/report_data.js reads it.

#pragma once

#include "tools/report_page/run_figures.h"

#include <cstddef>
#include <string>

#include <nlohmann/json.hpp>

namespace ffgpu::tools {

// Of the run in `folder`. Pictures and the pixels of draws fill what `most_bytes` leave.
nlohmann::ordered_json
run_data(const std::string& folder, const RunFigures& figures, std::size_t most_bytes);

} // namespace ffgpu::tools
