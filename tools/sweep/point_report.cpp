#include "tools/sweep/point_report.h"

#include "model/base/input_error.h"
#include "tools/config/config_file.h"
#include "tools/replay/replay.h"
#include "tools/report_page/report_page.h"
#include "tools/sweep/sweep_plan.h"
#include "tools/time/time_work.h"

#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace ffgpu::tools {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

Json read_plan(const fs::path& folder) {
    const fs::path path = folder / "plan.json";
    std::ifstream file(path);
    if (!file.is_open())
        throw InputError(fmt::format("{}: cannot be read: there is no sweep", path.string()));
    Json plan = Json::parse(file, nullptr, false);
    if (plan.is_discarded() || !plan.contains("traces") || !plan.contains("frames"))
        throw InputError(fmt::format("{}: is no sweep's plan", path.string()));
    return plan;
}

// A trace's id is its name, a dash, and a hash.
std::string name_in(const std::string& id) {
    return id.substr(0, id.rfind('-'));
}

std::string find_trace(const Json& plan, const PointReportOptions& options) {
    std::string found, names;
    for (const auto& [id, trace] : plan["traces"].items()) {
        names += (names.empty() ? "" : ", ") + name_in(id);
        if (options.trace.empty() ? plan["traces"].size() == 1 : name_in(id) == options.trace)
            found = id;
    }
    if (found.empty()) throw InputError("report --point: expected --trace with one of " + names);
    return found;
}

// The sweep's results are of what the file held then.
void check_unchanged(const std::string& input, const std::string& id, const std::string& frames) {
    if (id == name_in(id) + '-' + content_hash(input, frames)) return;
    throw InputError(input + ": is no longer what the sweep timed: sweep it again");
}

void draw_again(const std::string& trace, const Json& plan, const TimeOptions& run) {
    ReplayOptions drawing;
    drawing.input = trace;
    drawing.output = run.output;
    drawing.configuration = run.configuration;
    drawing.timing = drawing.draw_table = drawing.draw_pixels = true;
    const auto frames = plan["frames"].get<std::string>();
    if (!frames.empty()) drawing.frames = parse_frame_range(frames);
    replay(drawing);
}

} // namespace

std::string report_point(const PointReportOptions& options) {
    const fs::path folder = options.sweep;
    const Json plan = read_plan(folder);
    const std::string trace = find_trace(plan, options);
    const fs::path point = folder / "points" / (options.point + ".toml");
    if (!fs::exists(point))
        throw InputError(fmt::format(
            "{}: there is no point '{}': results.csv names them", folder.string(), options.point));
    TimeOptions run{.input = plan["traces"][trace].at("input").get<std::string>(),
                    .output = folder / "reports" / (name_in(trace) + '-' + options.point),
                    .configuration = {}};
    read_config_file(point, run.configuration);
    check_unchanged(run.input, trace, plan["frames"].get<std::string>());
    fs::create_directories(run.output);
    if (plan["traces"][trace].at("is_work").get<bool>())
        time_work(run);
    else
        draw_again(run.input, plan, run);
    ReportOptions page;
    page.folder = run.output;
    page.output = options.output;
    return write_report(page);
}

} // namespace ffgpu::tools
