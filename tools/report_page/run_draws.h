// What is told of single draws beside their cycles: facts of draws.csv and pixels of
// draw_pixels.csv.

#pragma once

#include "tools/report_page/csv_table.h"
#include "tools/report_page/run_figures.h"

#include <nlohmann/json_fwd.hpp>

namespace ffgpu::tools {

// By frame and entry of `commands`: the columns of draws.csv that the page shows, texts as places
// in a list of all. `is_of_run`: the entries are those of the run.
struct DrawFacts {
    bool is_of_run = false;
    std::vector<std::string> columns, texts;
    std::vector<std::vector<std::vector<std::size_t>>> places; // frame, entry, column
};
DrawFacts facts_of(const CsvTable& file, const RunFigures& figures);

// By frame and entry of `commands`: [left, top, width, height, pixels] or null. The costliest draws
// have them, as far as `most_bytes` go. `is_of_run`: they cover what those of the run do; of a
// version whose files do not tell that, all do.
// NOLINTNEXTLINE(bugprone-exception-escape): moving the JSON library's values throws nothing.
struct DrawPixelsOfRun {
    bool is_of_run = false;
    std::size_t left_out = 0; // draws for which there was no room
    nlohmann::ordered_json boxes;
};
DrawPixelsOfRun pixels_of(const CsvTable& file, const RunFigures& figures, std::size_t most_bytes);

} // namespace ffgpu::tools
