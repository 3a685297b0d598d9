#include "tools/report_page/report_page.h"

#include "model/base/input_error.h"
#include "model/base/whole_file.h"
#include "tools/page/assets.h"
#include "tools/page/json_text.h"
#include "tools/page/page.h"
#include "tools/report_page/run_data.h"
#include "tools/report_page/run_difference.h"

#include <array>
#include <cmath>
#include <filesystem>
#include <vector>

#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t MostPageBytes = 20'000'000;
constexpr std::size_t MostFrames = 1000;
// Of the page without its runs: the chart library, scripts, what is said twice.
constexpr std::size_t FrameworkBytes = 500'000;

constexpr std::array<std::string_view, 4> KindNames{"time", "traffic", "cache", "account"};

RunFigures figures_in(const std::string& folder, const FrameRange& range) {
    RunFigures figures = read_run_figures(folder, range);
    if (figures.frames.size() > MostFrames)
        throw InputError(fmt::format("{}: has {} frames, and a page room for {}: choose some with "
                                     "--frames A-B",
                                     folder,
                                     figures.frames.size(),
                                     MostFrames));
    return figures;
}

Json difference_json(const RunDifference& difference) {
    Json json{{"configuration", Json::array()}, {"figures", Json::array()}};
    for (const ParameterChange& change : difference.configuration)
        json["configuration"].push_back(
            {{"name", change.name}, {"before", change.before}, {"after", change.after}});
    for (const FigureChange& change : difference.figures)
        json["figures"].push_back({{"kind", KindNames[static_cast<std::size_t>(change.kind)]},
                                   {"name", change.name},
                                   {"before", change.before},
                                   {"after", change.after},
                                   {"whole", change.whole}});
    return json;
}

std::string value_text(const nlohmann::json& value) {
    if (value.is_null()) return "(none)";
    return value.is_string() ? value.get<std::string>() : json_text(value);
}

std::string difference_text(const RunDifference& difference) {
    constexpr std::size_t Shown = 8;
    std::string text;
    for (const ParameterChange& change : difference.configuration)
        text += fmt::format(
            "{}: {} -> {}\n", change.name, value_text(change.before), value_text(change.after));
    if (difference.figures.empty()) return text + "no figure differs\n";
    std::size_t shown = 0;
    for (const FigureChange& change : difference.figures) {
        if (change.kind == EffectKind::Account || shown++ >= Shown) continue;
        text += fmt::format("  {:+7.2f} %  {}: {} -> {}\n",
                            100 * change.effect(),
                            change.name,
                            change.before,
                            change.after);
    }
    return text;
}

std::string page_of(const Json& data, const std::string& title) {
    Page page{.title = "ffgpu report: " + title,
              .body = std::string(asset("report.html")),
              .data = json_text(data),
              .css = {"report.css"},
              .code = {ChartLibrary,
                       "report_data.js",
                       "report_table.js",
                       "report_charts.js",
                       "report_frames.js",
                       "report_draws.js",
                       "report_summary.js",
                       "report_time.js",
                       "report_machine.js",
                       "report_difference.js",
                       "report.js"}};
    const std::string licence = escaped(asset(ChartLicence));
    const std::string mark = "<!-- licence -->";
    page.body.replace(page.body.find(mark), mark.size(), licence);
    return html_of(page);
}

std::string path_of(const ReportOptions& options) {
    if (!options.output.empty()) return options.output;
    const bool is_difference = !options.other.empty();
    const std::filesystem::path folder(is_difference ? options.other : options.folder);
    return (folder / (is_difference ? "difference.html" : "report.html")).string();
}

} // namespace

std::string write_report(const ReportOptions& options) {
    if (asset(ChartLibrary).empty())
        throw InputError("report: ffgpu was built without a chart library: install libjs-chart.js "
                         "and build it again");
    if (options.output == "-")
        throw InputError("report: -o -: expected a file: a page is not printed");
    std::vector<std::string> folders{options.folder};
    if (!options.other.empty()) folders.push_back(options.other);
    std::vector<RunFigures> runs;
    runs.reserve(folders.size());
    for (const std::string& folder : folders)
        runs.push_back(figures_in(folder, options.frames));
    Json data;
    std::string text;
    if (runs.size() == 2) {
        check_same_work(runs[0], runs[1], {folders[0], folders[1]});
        const RunDifference changes = difference(runs[0], runs[1]);
        data["difference"] = difference_json(changes);
        text = difference_text(changes);
    }
    const std::size_t most_bytes = (MostPageBytes - FrameworkBytes) / runs.size();
    std::string title;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        data["runs"].push_back(run_data(folders[i], runs[i], most_bytes));
        title += (i > 0 ? " and " : "") + data["runs"].back()["name"].get<std::string>();
    }
    const std::string page = page_of(data, title);
    const std::string path = path_of(options);
    WholeFile file(path);
    file.write(page);
    file.commit();
    const std::uint64_t frames = runs.front().frames.back().number + 1;
    if (const std::string line = missing_frames(options.frames, options.folder, frames);
        !line.empty())
        text += line + '\n';
    return text + fmt::format("{}: {} frames, {:.1f} MB\n",
                              path,
                              runs.front().frames.size(),
                              static_cast<double>(page.size()) / 1e6);
}

} // namespace ffgpu::tools
