// `ffgpu report`: what folders of runs hold, as one page. docs/report.md tells what it shows.

#pragma once

#include "tools/frames/frame_range.h"

#include <string>

namespace ffgpu::tools {

struct ReportOptions {
    std::string folder;
    std::string other;  // a second run of the same work; empty: none
    std::string output; // empty: report.html in the folder, or difference.html in the other one
    FrameRange frames;
};

// Writes the page, and returns a few lines for people. Throws InputError.
std::string write_report(const ReportOptions& options);

} // namespace ffgpu::tools
