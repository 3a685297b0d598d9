// A suite of pictures to check: traces, frames, references, tolerances, from a TOML file.
// docs/command_line.md has an example.

#pragma once

#include "tools/frames/frame_range.h"

#include <optional>
#include <string>
#include <vector>

namespace ffgpu::tools {

struct Tolerance {
    double max_rmse = 0;               // over R, G, B, in units of 0 to 255
    std::optional<unsigned> max_worst; // of any pixel's channel; nothing: any
};

struct SuiteTrace {
    std::string name;      // of its folder, one of a kind
    std::string input;     // a trace or a capture
    std::string reference; // a folder with frame_0000.png ...
    FrameRange frames;
    Tolerance tolerance;
    unsigned samples = 1;
};

struct Suite {
    std::string name;
    std::vector<SuiteTrace> traces; // at least one
};

// Paths in the file count from its folder. Throws InputError that names the line.
Suite read_suite(const std::string& path);

} // namespace ffgpu::tools
