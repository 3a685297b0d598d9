// Miss-rate curves of curves.csv, as `ffgpu cache` writes it, for a chart.

#pragma once

#include "tools/report_page/csv_table.h"
#include "tools/report_page/run_figures.h"

namespace ffgpu::tools {

// A list of {name, accesses, ways: {"1": [[bytes, misses], ...], ..., "full": ...}}.
nlohmann::ordered_json miss_curves(const CsvTable& file);

// Whether they may be of the run's work, by the texels that it reads: these depend on no cache.
// Where either tells of none, they may.
bool are_curves_of(const CsvTable& file, const RunFigures& figures);

} // namespace ffgpu::tools
