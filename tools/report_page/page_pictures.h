// The pictures of a run for a page: frames, heat maps and views, as data within it. Where they
// would make it too large they are shrunk, all by the same factor.

#pragma once

#include "tools/report_page/run_figures.h"

#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace ffgpu::tools {

// NOLINTNEXTLINE(bugprone-exception-escape): moving the JSON library's values throws nothing.
struct PagePictures {
    unsigned shrunk = 1;       // each side was divided by this
    std::size_t left_out = 0;  // pictures for which there was no room at all
    std::size_t of_others = 0; // of another run, as the list or their size tells
    std::set<std::string> maps_of_others;
    std::vector<std::string> maps; // "frame", "heat_cycles" ...: those that there are
    // By frame: {map: {body, legend}}. A body may hold the legend below its picture; one that was
    // shrunk has it beside.
    nlohmann::ordered_json frames;
};

// Those in `folder`. Throws InputError where one cannot be read or is damaged.
PagePictures
pictures_of(const std::string& folder, const RunFigures& figures, std::size_t most_bytes);

} // namespace ffgpu::tools
