// The page of one point of a sweep, which keeps no more than the sums of each: its work runs once
// more, with all that a page shows.

#pragma once

#include <string>

namespace ffgpu::tools {

struct PointReportOptions {
    std::string sweep;       // its folder
    std::string point;       // as the table names it
    std::string trace;       // as the table names it; may be empty where the sweep has one alone
    std::string output = {}; // of the page; empty: report.html in the run's folder
};

// Runs into the sweep's folder reports/TRACE-POINT and makes its page. Returns a few lines for
// people. Throws InputError.
std::string report_point(const PointReportOptions& options);

} // namespace ffgpu::tools
