#include "tools/report_page/run_draws.h"

#include "model/base/input_error.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <tuple>

#include <nlohmann/json.hpp>

namespace ffgpu::tools {
namespace {

// A draw, by which it is found again: frame, kind, number, and which of several of that number.
using DrawName = std::tuple<std::uint64_t, std::string, std::uint64_t, std::size_t>;

struct Place {
    std::size_t frame, entry;
};

// Clears and copies have no numbers of their own: they are told apart by their order.
class Occurrences {
public:
    DrawName next(std::uint64_t frame, std::string kind, std::uint64_t draw) {
        std::size_t& count = counts_[{frame, kind, draw}];
        return {frame, std::move(kind), draw, count++};
    }

private:
    std::map<std::tuple<std::uint64_t, std::string, std::uint64_t>, std::size_t> counts_;
};

std::map<DrawName, Place> places_of(const RunFigures& figures) {
    std::map<DrawName, Place> places;
    Occurrences occurrences;
    for (std::size_t frame = 0; frame < figures.commands.size(); ++frame)
        for (std::size_t entry = 0; entry < figures.commands[frame].size(); ++entry) {
            const RunCommand& command = figures.commands[frame][entry];
            const auto name =
                occurrences.next(figures.frames[frame].number, command.kind, command.draw);
            places[name] = {frame, entry};
        }
    return places;
}

// Calls `visit(line, place)` for each line whose draw is on the page. False: the page has draws,
// the file has lines, and no line is of a draw: they are of two runs.
template <class Visitor>
bool for_each_draw(const CsvTable& file, const RunFigures& figures, Visitor&& visit) {
    const auto places = places_of(figures);
    const std::size_t frame = file.wanted_column("frame"), kind = file.wanted_column("kind"),
                      draw = file.wanted_column("draw");
    Occurrences occurrences;
    bool any = file.rows() == 0 || places.empty();
    for (std::size_t line = 0; line < file.rows(); ++line) {
        const auto name = occurrences.next(
            file.number(line, frame), std::string(file.text(line, kind)), file.number(line, draw));
        const auto found = places.find(name);
        if (found == places.end()) continue;
        any = true;
        visit(line, found->second);
    }
    return any;
}

constexpr std::array<std::string_view, 6> ShownFacts{
    "function", "call", "primitive", "vertices", "texel_cache_misses", "textures"};

} // namespace

DrawFacts facts_of(const CsvTable& file, const RunFigures& figures) {
    DrawFacts facts;
    facts.is_of_run = true;
    std::vector<std::size_t> columns;
    for (const std::string_view name : ShownFacts)
        if (const auto column = file.column(name)) {
            columns.push_back(*column);
            facts.columns.emplace_back(name);
        }
    for (const auto& commands : figures.commands)
        facts.places.emplace_back(commands.size());
    const std::size_t cycles = file.wanted_column("cycles");
    std::map<std::string_view, std::size_t> known;
    const bool any = for_each_draw(file, figures, [&](std::size_t line, const Place& place) {
        const RunCommand& command = figures.commands[place.frame][place.entry];
        const bool has_cycles = !file.text(line, cycles).empty();
        if (has_cycles && file.number(line, cycles) != command.cycles) facts.is_of_run = false;
        for (const std::size_t column : columns) {
            const std::string_view text = file.text(line, column);
            const auto [found, is_new] = known.try_emplace(text, facts.texts.size());
            if (is_new) facts.texts.emplace_back(text);
            facts.places[place.frame][place.entry].push_back(found->second);
        }
    });
    facts.is_of_run &= any;
    return facts;
}

DrawPixelsOfRun pixels_of(const CsvTable& file, const RunFigures& figures, std::size_t most_bytes) {
    struct Found {
        std::uint64_t cycles;
        std::size_t line;
        Place place;
    };
    const auto covered = file.column("fragments_covered");
    const auto written = file.column("fragments_written");
    const auto is_same = [&](std::size_t line, const RunCommand& command) {
        return !covered || !written ||
               (file.number(line, *covered) == command.covered &&
                file.number(line, *written) == command.written);
    };
    DrawPixelsOfRun result;
    result.is_of_run = true;
    std::vector<Found> draws;
    const bool any = for_each_draw(file, figures, [&](std::size_t line, const Place& place) {
        const RunCommand& command = figures.commands[place.frame][place.entry];
        if (!is_same(line, command)) result.is_of_run = false;
        draws.push_back({command.cycles, line, place});
    });
    result.is_of_run &= any;
    std::stable_sort(draws.begin(), draws.end(), [](const Found& a, const Found& b) {
        return a.cycles > b.cycles;
    });
    for (const auto& commands : figures.commands)
        result.boxes.push_back(std::vector<std::nullptr_t>(commands.size()));
    const std::array columns{file.wanted_column("left"),
                             file.wanted_column("top"),
                             file.wanted_column("width"),
                             file.wanted_column("height")};
    const std::size_t pixels = file.wanted_column("pixels");
    constexpr std::size_t Overhead = 30; // of the box's numbers
    for (const Found& draw : draws) {
        const std::size_t bytes = file.text(draw.line, pixels).size() + Overhead;
        if (bytes > most_bytes) {
            ++result.left_out;
            continue;
        }
        most_bytes -= bytes;
        auto& box = result.boxes[draw.place.frame][draw.place.entry];
        for (const std::size_t column : columns)
            box.push_back(file.number(draw.line, column));
        box.push_back(file.text(draw.line, pixels));
    }
    return result;
}

} // namespace ffgpu::tools
