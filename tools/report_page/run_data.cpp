#include "tools/report_page/run_data.h"

#include "model/base/input_error.h"
#include "tools/page/json_text.h"
#include "tools/report_page/csv_table.h"
#include "tools/report_page/miss_curves.h"
#include "tools/report_page/page_pictures.h"
#include "tools/report_page/run_draws.h"
#include "tools/report_page/run_series.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <numeric>

#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t MostCommands = 60000; // on a page

// The last part of the path: a page does not tell where it was made.
std::string name_of(const std::string& folder) {
    const auto path = std::filesystem::absolute(folder).lexically_normal();
    return (path.has_filename() ? path : path.parent_path()).filename().string();
}

std::optional<CsvTable> file_in(const std::string& folder, const char* name) {
    return CsvTable::read((std::filesystem::path(folder) / name).string());
}

Json table_json(const FigureTable& table) {
    Json json = Json::object();
    for (const auto& [name, column] : table)
        json[name] = column;
    return json;
}

Json frames_json(const RunFigures& figures) {
    Json json = Json::array();
    for (const RunFrame& frame : figures.frames)
        json.push_back({{"frame", frame.number},
                        {"width", frame.width},
                        {"height", frame.height},
                        {"api_calls", frame.api_calls},
                        {"overdraw", frame.overdraw},
                        {"milliseconds", frame.milliseconds}});
    return json;
}

// Texts that come again and again, as places in a list.
class TextList {
public:
    std::size_t place(const std::string& text) {
        const auto [found, is_new] = places_.try_emplace(text, texts_.size());
        if (is_new) texts_.push_back(text);
        return found->second;
    }
    const std::vector<std::string>& texts() const { return texts_; }

private:
    std::map<std::string, std::size_t> places_;
    std::vector<std::string> texts_;
};

// Frames by columns.
Json commands_json(const RunFigures& figures, TextList& kinds, TextList& resources) {
    Json json = Json::array();
    for (const auto& commands : figures.commands) {
        const auto column = [&](const auto& value_of) {
            Json values = Json::array();
            for (const RunCommand& command : commands)
                values.push_back(value_of(command));
            return values;
        };
        json.push_back(
            {{"kind", column([&](const RunCommand& c) { return kinds.place(c.kind); })},
             {"draw", column([](const RunCommand& c) { return c.draw; })},
             {"count", column([](const RunCommand& c) { return c.count; })},
             {"cycles", column([](const RunCommand& c) { return c.cycles; })},
             {"bottleneck",
              column([&](const RunCommand& c) { return resources.place(c.bottleneck); })},
             {"bottleneck_cycles", column([](const RunCommand& c) { return c.bottleneck_cycles; })},
             {"pieces", column([](const RunCommand& c) { return c.pieces; })},
             {"quads", column([](const RunCommand& c) { return c.quads; })},
             {"covered", column([](const RunCommand& c) { return c.covered; })},
             {"written", column([](const RunCommand& c) { return c.written; })}});
    }
    return json;
}

// What a part of the page lacks, and which command fills it.
class Notes {
public:
    void add(const char* part, const std::string& text) { json_[part].push_back(text); }
    const Json& json() const { return json_; }

private:
    Json json_ = Json::object();
};

void add_series(Json& data, Notes& notes, const std::string& folder, const RunFigures& figures) {
    const auto file = file_in(folder, "series.csv");
    if (!file)
        return notes.add("series",
                         "One point a frame. With --set series.interval_cycles=20000 the run "
                         "leaves series.csv, and the machine is seen within each frame.");
    if (!is_series_of(*file, figures))
        return notes.add("series", "series.csv is of another run than stats.json: left out.");
    const RunSeries series = series_of(*file, figures);
    if (series.joined > 1)
        notes.add("series",
                  fmt::format("A point is {} rows of series.csv, or what a frame has left of them.",
                              series.joined));
    data["series"] = {{"joined", series.joined},
                      {"frame", series.frame},
                      {"cycles", series.cycles},
                      {"columns", table_json(series.columns)}};
}

void add_facts(Json& data, Notes& notes, const std::string& folder, const RunFigures& figures) {
    const auto file = file_in(folder, "draws.csv");
    if (!file)
        return notes.add("draws",
                         "Which call a draw came from, its vertices and textures come with "
                         "--per-draw.");
    const DrawFacts facts = facts_of(*file, figures);
    if (!facts.is_of_run)
        return notes.add("draws", "draws.csv is of another run than stats.json: left out.");
    data["facts"] = {{"columns", facts.columns}, {"texts", facts.texts}, {"places", facts.places}};
}

std::size_t add_pixels(Json& data,
                       Notes& notes,
                       const std::string& folder,
                       const RunFigures& figures,
                       std::size_t most_bytes) {
    const auto file = file_in(folder, "draw_pixels.csv");
    if (!file) {
        notes.add("pixels",
                  "Which pixels a draw covers is not known. A run with --draw-pixels leaves "
                  "draw_pixels.csv, and a click on a draw shows them.");
        return 0;
    }
    DrawPixelsOfRun pixels = pixels_of(*file, figures, most_bytes);
    if (!pixels.is_of_run) {
        notes.add("pixels", "draw_pixels.csv is of another run than stats.json: left out.");
        return 0;
    }
    if (pixels.left_out > 0)
        notes.add("pixels",
                  fmt::format("The pixels of {} draws, the cheapest, are left out to keep the "
                              "page small.",
                              pixels.left_out));
    const std::size_t bytes = json_text(pixels.boxes).size();
    data["pixels"] = std::move(pixels.boxes);
    return bytes;
}

void add_pictures(Json& data, Notes& notes, const PagePictures& pictures) {
    data["pictures"] = {
        {"shrunk", pictures.shrunk}, {"maps", pictures.maps}, {"frames", pictures.frames}};
    if (pictures.maps.empty())
        notes.add("pictures", "There are no pictures: the run wrote none (ffgpu replay does).");
    else if (pictures.maps.size() == 1)
        notes.add("pictures",
                  "Heat maps come with --heatmap overdraw,depth_killed,quad_lanes,level,texture,"
                  "texture_misses,cycles.");
    if (pictures.shrunk > 1)
        notes.add("pictures",
                  fmt::format("Pictures are shrunk to 1/{} of each side to keep the page small.",
                              pictures.shrunk));
    if (pictures.left_out > 0)
        notes.add(
            "pictures",
            fmt::format("{} pictures are left out to keep the page small.", pictures.left_out));
    if (pictures.of_others > 0)
        notes.add("pictures",
                  fmt::format("Pictures of another run than stats.json are left out: {} ({}).",
                              pictures.of_others,
                              fmt::join(pictures.maps_of_others, ", ")));
}

void add_curves(Json& data, Notes& notes, const std::string& folder, const RunFigures& figures) {
    const auto file = file_in(folder, "curves.csv");
    if (!file)
        return notes.add("curves",
                         "Miss-rate curves of all caches come from ffgpu cache TRACE -o DIR, into "
                         "the same folder.");
    if (!are_curves_of(*file, figures))
        notes.add("curves",
                  "curves.csv is of other work than stats.json: of other frames, or of another "
                  "trace.");
    data["curves"] = Json::array();
    std::string left_out;
    for (Json& curve : miss_curves(*file))
        if (curve["accesses"] != 0)
            data["curves"].push_back(std::move(curve));
        else
            left_out += (left_out.empty() ? "" : "; ") + curve["name"].get<std::string>();
    if (!left_out.empty())
        notes.add("curves", "Nothing was looked up, so that there is no curve: " + left_out + '.');
}

bool reckons_waits(const RunFigures& figures) {
    return std::any_of(figures.timing.begin(), figures.timing.end(), [](const auto& figure) {
        return figure.first.starts_with("bottleneck_") && total(figure.second) > 0;
    });
}

// The costliest of all frames stay, and the rest of each frame is one entry.
RunFigures with_few_commands(RunFigures figures, Notes& notes) {
    std::vector<std::uint64_t> cycles;
    for (const auto& commands : figures.commands)
        for (const RunCommand& command : commands)
            cycles.push_back(command.cycles);
    if (cycles.size() <= MostCommands) return figures;
    std::nth_element(cycles.begin(), cycles.begin() + MostCommands, cycles.end(), std::greater<>());
    const std::uint64_t least = cycles[MostCommands];
    for (auto& commands : figures.commands) {
        RunCommand rest{.kind = "rest", .count = 0};
        std::map<std::string, std::uint64_t> waits;
        std::erase_if(commands, [&](const RunCommand& command) {
            if (command.cycles > least) return false;
            rest.count += command.count;
            rest.cycles += command.cycles;
            rest.pieces += command.pieces;
            rest.quads += command.quads;
            rest.covered += command.covered;
            rest.written += command.written;
            waits[command.bottleneck] += command.bottleneck_cycles;
            return true;
        });
        for (const auto& [resource, waited] : waits)
            if (rest.bottleneck.empty() || waited > rest.bottleneck_cycles) {
                rest.bottleneck = resource;
                rest.bottleneck_cycles = waited;
            }
        if (rest.count > 0) commands.push_back(rest);
    }
    notes.add("draws",
              fmt::format("Commands of at most {} cycles are one line a frame, rest, to keep the "
                          "page small.",
                          least));
    return figures;
}

} // namespace

Json run_data(const std::string& folder, const RunFigures& all, std::size_t most_bytes) {
    Notes notes;
    const RunFigures figures = with_few_commands(all, notes);
    Json data{{"name", name_of(folder)},
              {"configuration", figures.configuration},
              {"frames", frames_json(figures)},
              {"functional", table_json(figures.functional)}};
    if (figures.has_timing()) {
        TextList kinds, resources;
        data["timing"] = table_json(figures.timing);
        data["histograms"] = figures.histograms;
        data["commands"] = commands_json(figures, kinds, resources);
        data["kinds"] = kinds.texts();
        data["resources"] = resources.texts();
        if (!reckons_waits(figures))
            notes.add("waits",
                      "What the machine waited for was not reckoned (bottlenecks.enable=false).");
        add_series(data, notes, folder, figures);
        add_facts(data, notes, folder, figures);
    } else {
        notes.add("timing",
                  "There is no timing: a run with --timing tells cycles, caches and memory.");
    }
    add_curves(data, notes, folder, figures);
    const std::size_t figure_bytes = json_text(data).size();
    std::size_t left = most_bytes - std::min(most_bytes, figure_bytes);
    // A quarter for the pixels of draws: the pictures can be shrunk.
    if (figures.has_timing()) left -= add_pixels(data, notes, folder, figures, left / 4);
    add_pictures(data, notes, pictures_of(folder, figures, left));
    data["notes"] = notes.json();
    return data;
}

} // namespace ffgpu::tools
