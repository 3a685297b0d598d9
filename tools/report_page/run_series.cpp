#include "tools/report_page/run_series.h"

#include <algorithm>
#include <map>
#include <optional>

namespace ffgpu::tools {
namespace {

constexpr std::size_t MostRows = 1200;

std::map<std::uint64_t, std::size_t> places_of(const RunFigures& figures) {
    std::map<std::uint64_t, std::size_t> places;
    for (std::size_t i = 0; i < figures.frames.size(); ++i)
        places[figures.frames[i].number] = i;
    return places;
}

bool is_wanted(std::string_view name) {
    const bool is_traffic = name.starts_with("memory_") &&
                            (name.ends_with("_read_bytes") || name.ends_with("_written_bytes"));
    const bool is_account = name.ends_with("_busy_cycles") || name.ends_with("_idle_cycles") ||
                            name.find("_stalled_") != std::string_view::npos;
    return is_traffic || is_account || name.starts_with("bottleneck_") ||
           name == "memory_bus_cycles" || name == "memory_data_cycles";
}

// The file's rows whose frames are shown, and where they belong.
struct Row {
    std::size_t line, frame;
};

std::vector<Row> rows_of(const CsvTable& file, const RunFigures& figures) {
    const auto places = places_of(figures);
    const std::size_t frame = file.wanted_column("frame");
    std::vector<Row> rows;
    for (std::size_t line = 0; line < file.rows(); ++line)
        if (const auto found = places.find(file.number(line, frame)); found != places.end())
            rows.push_back({line, found->second});
    return rows;
}

} // namespace

bool is_series_of(const CsvTable& file, const RunFigures& figures) {
    const std::size_t cycles = file.wanted_column("cycles");
    FigureColumn sums(figures.frames.size());
    for (const Row& row : rows_of(file, figures))
        sums[row.frame] += file.number(row.line, cycles);
    for (std::size_t i = 0; i < sums.size(); ++i)
        if (sums[i] != figures.frame_cycles(i)) return false;
    return true;
}

RunSeries series_of(const CsvTable& file, const RunFigures& figures) {
    const std::vector<Row> rows = rows_of(file, figures);
    RunSeries series;
    series.joined = std::max<std::size_t>(1, (rows.size() + MostRows - 1) / MostRows);
    std::vector<std::size_t> to; // the series' row of each of `rows`
    std::size_t in_row = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (i == 0 || rows[i].frame != rows[i - 1].frame || in_row == series.joined) {
            series.frame.push_back(rows[i].frame);
            in_row = 0;
        }
        ++in_row;
        to.push_back(series.frame.size() - 1);
    }
    const auto joined = [&](std::size_t column) {
        FigureColumn sums(series.frame.size());
        for (std::size_t i = 0; i < rows.size(); ++i)
            sums[to[i]] += file.number(rows[i].line, column);
        return sums;
    };
    series.cycles = joined(file.wanted_column("cycles"));
    for (std::size_t column = 0; column < file.names().size(); ++column) {
        if (!is_wanted(file.names()[column])) continue;
        FigureColumn sums = joined(column);
        if (total(sums) > 0) series.columns.emplace_back(file.names()[column], std::move(sums));
    }
    return series;
}

} // namespace ffgpu::tools
