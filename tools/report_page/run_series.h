// RunSeries: the accounts of a run over time, of series.csv: as many rows as a chart can show.

#pragma once

#include "tools/report_page/csv_table.h"
#include "tools/report_page/run_figures.h"

#include <string>
#include <vector>

namespace ffgpu::tools {

struct RunSeries {
    FigureColumn frame;     // a row's place in RunFigures::frames
    FigureColumn cycles;    // that it covers
    FigureTable columns;    // what was counted in them
    std::size_t joined = 1; // rows of the file in one
};

// True: it is of this run, that is, it has the cycles of each of its frames.
bool is_series_of(const CsvTable& file, const RunFigures& figures);

// Rows of one frame are added up until all fit.
RunSeries series_of(const CsvTable& file, const RunFigures& figures);

} // namespace ffgpu::tools
