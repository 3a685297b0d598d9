// RunFigures: what stats.json tells of a run, checked and by columns: a figure is a list with a
// place for each frame.

#pragma once

#include "tools/frames/frame_range.h"

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace ffgpu::tools {

using FigureColumn = std::vector<std::uint64_t>; // a place a frame
using FigureTable = std::vector<std::pair<std::string, FigureColumn>>;

struct RunFrame {
    std::uint64_t number = 0, width = 0, height = 0, api_calls = 0;
    double milliseconds = 0, overdraw = 0;
};

// An entry of `commands`; transfers of the host are joined to one of a kind and frame.
struct RunCommand {
    std::string kind{};
    std::uint64_t draw = 0, count = 1; // how many are joined
    std::uint64_t cycles = 0, bottleneck_cycles = 0;
    std::string bottleneck{};
    std::uint64_t pieces = 0, quads = 0, covered = 0, written = 0;
};

struct RunFigures {
    // "texel_cache.ways" and its value; empty without timing, as `timing` and `commands`.
    std::vector<std::pair<std::string, nlohmann::json>> configuration;
    std::vector<RunFrame> frames;
    FigureTable functional, timing;
    std::map<std::string, FigureColumn> histograms; // of the frames together; a place a value
    std::vector<std::vector<RunCommand>> commands;  // a list a frame

    bool has_timing() const { return !timing.empty(); }
    std::uint64_t frame_cycles(std::size_t frame) const;
};

// Null: there is no such figure.
const FigureColumn* find_figure(const FigureTable& table, const std::string& name);
std::uint64_t total(const FigureColumn& column);

// The frames of DIR/stats.json that lie in `range`. Throws InputError.
RunFigures read_run_figures(const std::string& folder, const FrameRange& range);

} // namespace ffgpu::tools
