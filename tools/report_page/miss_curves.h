// Miss-rate curves of curves.csv, as `ffgpu cache` writes it, for a chart.

#pragma once

#include "tools/report_page/csv_table.h"

#include <nlohmann/json_fwd.hpp>

namespace ffgpu::tools {

// A list of {name, accesses, ways: {"1": [[bytes, misses], ...], ..., "full": ...}}.
nlohmann::ordered_json miss_curves(const CsvTable& file);

} // namespace ffgpu::tools
