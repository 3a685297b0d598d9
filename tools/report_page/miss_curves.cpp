#include "tools/report_page/miss_curves.h"

#include <array>
#include <map>
#include <set>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace ffgpu::tools {
namespace {

const std::set<std::uint64_t> ShownWays{1, 2, 4, 8};

class Names {
public:
    explicit Names(const CsvTable& file)
        : file_(file) {
        constexpr std::array<std::string_view, 8> Wanted{"client",
                                                         "level",
                                                         "layout",
                                                         "traversal",
                                                         "tile_width",
                                                         "granularity",
                                                         "merged",
                                                         "line_bytes"};
        for (std::size_t i = 0; i < columns_.size(); ++i)
            columns_[i] = file.wanted_column(Wanted[i]);
    }

    // "texel, blocked, tiled 8, lines of 64 bytes"
    std::string name(std::size_t line) const {
        const auto text = [&](std::size_t i) { return file_.text(line, columns_[i]); };
        std::string name(text(0));
        if (text(1) == "2") name += " behind the first level";
        if (text(0) != "vertex") {
            name += fmt::format(", {}, {}", text(2), text(3));
            if (text(4) != "0") name += fmt::format(" {}", text(4));
            if (text(5) != "quad") name += fmt::format(", by {}", text(5));
            if (text(6) == "0") name += ", unmerged";
        }
        return name + fmt::format(", lines of {} bytes", text(7));
    }

private:
    const CsvTable& file_;
    std::array<std::size_t, 8> columns_{};
};

} // namespace

bool are_curves_of(const CsvTable& file, const RunFigures& figures) {
    const FigureColumn* const texels = find_figure(figures.timing, "texture_texel_reads");
    if (!texels) return true;
    const std::size_t client = file.wanted_column("client"), level = file.wanted_column("level"),
                      reads = file.wanted_column("reads");
    for (std::size_t line = 0; line < file.rows(); ++line)
        if (file.text(line, client) == "texel" && file.text(line, level) == "1")
            return file.number(line, reads) == total(*texels);
    return true;
}

nlohmann::ordered_json miss_curves(const CsvTable& file) {
    const Names names(file);
    const std::size_t sets = file.wanted_column("sets"), ways = file.wanted_column("ways"),
                      bytes = file.wanted_column("bytes"), misses = file.wanted_column("misses"),
                      accesses = file.wanted_column("accesses");
    auto curves = nlohmann::ordered_json::array();
    std::map<std::string, std::size_t> places;
    for (std::size_t line = 0; line < file.rows(); ++line) {
        const auto [found, is_new] = places.try_emplace(names.name(line), curves.size());
        if (is_new)
            curves.push_back({{"name", found->first},
                              {"accesses", file.number(line, accesses)},
                              {"ways", nlohmann::ordered_json::object()}});
        nlohmann::ordered_json& by_ways = curves[found->second]["ways"];
        const nlohmann::ordered_json point{file.number(line, bytes), file.number(line, misses)};
        const std::uint64_t of_line = file.number(line, ways);
        if (ShownWays.contains(of_line)) by_ways[std::to_string(of_line)].push_back(point);
        const bool is_power_of_two = (of_line & (of_line - 1)) == 0;
        if (file.number(line, sets) == 1 && is_power_of_two) by_ways["full"].push_back(point);
    }
    return curves;
}

} // namespace ffgpu::tools
