// Replay: a trace or a capture in; pictures, heat maps, statistics, a capture out.

#pragma once

#include "tools/config/configuration.h"
#include "tools/replay/frame_range.h"
#include "tools/replay/heat_maps.h"

#include <functional>
#include <set>
#include <string>

namespace ffgpu::tools {

struct ReplayOptions {
    std::string input;
    std::string output; // a folder; empty: nothing is written
    std::string capture;
    FrameRange frames;
    Configuration configuration;
    std::set<HeatMap> heat_maps;
    bool timing = false;
    bool images = true;
    bool report_errors = false;
    unsigned benchmark = 0; // times that the last frame is repeated; 0: no benchmark
    std::function<void(const std::string& line)> warn = [](const std::string&) {};
};

// Returns a summary for people. Throws InputError; what was finished before is written.
std::string replay(const ReplayOptions& options);

} // namespace ffgpu::tools
