// ListedPictures: which pictures in a folder are of the run that its stats.json tells of, by
// pictures.csv.

#pragma once

#include "tools/report_page/run_figures.h"

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <utility>

namespace ffgpu::tools {

class ListedPictures {
public:
    // Throws InputError where the list is damaged.
    ListedPictures(const std::string& folder, const RunFigures& figures);

    // `frame` is a place in RunFigures::frames, `map` "frame", "heat_cycles" ... Where there is no
    // list, as of a version that wrote none, all pictures count as the run's.
    bool holds(std::size_t frame, const std::string& map) const {
        return !listed_ || listed_->contains({frame, map});
    }

private:
    std::optional<std::set<std::pair<std::size_t, std::string>>> listed_;
};

} // namespace ffgpu::tools
