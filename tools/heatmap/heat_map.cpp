#include "tools/heatmap/heat_map.h"

#include "model/base/input_error.h"
#include "tools/config/nearest_name.h"

#include <algorithm>
#include <sstream>
#include <vector>

namespace ffgpu::tools {

std::set<HeatMap> parse_heat_maps(const std::string& names) {
    std::set<HeatMap> maps;
    std::istringstream list(names);
    for (std::string name; std::getline(list, name, ',');) {
        const auto* const found = std::ranges::find(HeatMapTable, name, &HeatMapInfo::name);
        if (found == HeatMapTable.end()) {
            std::vector<std::string> known;
            known.reserve(HeatMapTable.size());
            for (const HeatMapInfo& map : HeatMapTable)
                known.emplace_back(map.name);
            throw InputError("--heatmap: unknown map " + name + "; did you mean " +
                             nearest_name(name, known) + "?");
        }
        maps.insert(static_cast<HeatMap>(found - HeatMapTable.begin()));
    }
    return maps;
}

std::string heat_map_names() {
    std::string names;
    for (const HeatMapInfo& map : HeatMapTable)
        names.append(names.empty() ? "" : ", ").append(map.name);
    return names;
}

} // namespace ffgpu::tools
