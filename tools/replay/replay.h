// Replay: a trace or a capture in; pictures, heat maps, statistics, a capture out.

#pragma once

#include "driver/framebuffer/drawable.h"
#include "tools/record/recording.h"
#include "tools/rtl/rtl_device.h"

#include <string>

namespace ffgpu::tools {

struct ReplayOptions : RecordingOptions {
    std::string input;
    bool report_errors = false;
    unsigned benchmark = 0;   // times that the last frame is repeated; 0: no benchmark
    bool player_only = false; // Nothing is drawn: what is timed is the player and the driver.
    unsigned samples = 1;     // of a pixel of a trace's windows
    gl::SwapMode swap = gl::SwapMode::Copy;
    RtlDevice* rtl = nullptr; // draws and compares; whoever has it commits it behind
};

// Returns a summary for people. Throws InputError; what was finished before is written.
std::string replay(const ReplayOptions& options);

} // namespace ffgpu::tools
