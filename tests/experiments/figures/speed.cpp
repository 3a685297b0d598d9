// P13: how fast the emulator itself is.

#include "tests/experiments/figures/all.h"
#include "tests/support/temporary_folder.h"
#include "tools/replay/replay.h"
#include "tools/time/time_work.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace ffgpu::experiments {
namespace {

// ATTILA compiled with -O3; its fork computrendering on glxgears at 300 x 300.
constexpr double AttilaKilohertz = 13.8, ForkFrames = 0.9;
constexpr double TimedGoal = 100, DrawnGoal = 1000; // kHz

double seconds(const std::function<void()>& work) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

nlohmann::json statistics(const std::string& folder) {
    std::ifstream file(folder + "/stats.json");
    return nlohmann::json::parse(file);
}

tools::ReplayOptions drawing_of(const std::string& trace, const std::string& output) {
    tools::ReplayOptions drawing;
    drawing.input = trace;
    drawing.output = output;
    drawing.images = false;
    return drawing;
}

Row trace_row(const std::string& name) {
    const std::string trace = std::string(FFGPU_SOURCE_DIR) + "/traces/" + name + ".trace";
    const TemporaryFolder folder;
    tools::ReplayOptions drawing = drawing_of(trace, folder / "drawn");
    const double drawn = seconds([&] { tools::replay(drawing); });
    drawing.output = folder / "saved";
    drawing.save_work = folder / "work.ffw";
    tools::replay(drawing);
    tools::TimeOptions timing{
        .input = drawing.save_work, .output = folder / "timed", .configuration = {}};
    const double timed = seconds([&] { tools::time_work(timing); });
    const nlohmann::json figures = statistics(folder / "timed");
    const double kilocycles =
        1e-3 * figures.at("totals").at("timing").at("total_cycles").get<double>();
    constexpr double Any = 1e9;
    return {name,
            {},
            {{"obtained",
              {kilocycles / timed,
               kilocycles / drawn,
               statistics(folder / "drawn").at("frame_count").get<double>() / drawn},
              {{AttilaKilohertz, Any}, {AttilaKilohertz, Any}, {ForkFrames, Any}}}}};
}

} // namespace

Experiment speed() {
    Table table{"",
                {"trace",
                 "kHz of the machine in time",
                 "kHz drawn alone, by the same cycles",
                 "frames a second drawn"},
                {},
                1};
    tools::Plot plot{"Speed in time", "trace", "kHz"};
    plot.counts = true;
    tools::PlotSeries& series = plot.series.emplace_back(tools::PlotSeries{"in time", {}});
    double least_timed = 1e9, least_drawn = 1e9;
    for (const char* const name : {"chrome", "corridor", "light_maps"}) {
        table.rows.push_back(trace_row(name));
        const std::vector<double>& values = table.rows.back().lines[0].values;
        series.points.emplace_back(std::uint64_t{1} << series.points.size(), values[0]);
        least_timed = std::min(least_timed, values[0]);
        least_drawn = std::min(least_drawn, values[1]);
    }
    return {.id = "P13",
            .title = "The emulator's own speed",
            .source = "ATTILA, compiled with -O3: 13.8 kHz, measured; its fork computrendering on "
                      "glxgears of 300 x 300: 0.9 frames a second",
            .method = "The project's traces, once drawn and once in time, in the time of the wall; "
                      "other figures on every host and with every load. In the chart the traces in "
                      "the table's order.",
            .tables = {table},
            .claims = {{"in time at least 100 kHz",
                        fmt::format("{:.0f}", least_timed),
                        least_timed >= TimedGoal},
                       {"drawn at least 1 MHz",
                        fmt::format("{:.0f} kHz", least_drawn),
                        least_drawn >= DrawnGoal}},
            .plots = {{"p13_speed", svg(plot)}}};
}

} // namespace ffgpu::experiments
