// The files that pages are made of: style sheets and scripts of tools/page/web, and the chart
// library. They are read when ffgpu is built, so that the program is all that a page needs.

#pragma once

#include <string_view>

namespace ffgpu::tools {

constexpr std::string_view ChartLibrary = "chart.min.js"; // of Debian's libjs-chart.js
constexpr std::string_view ChartLicence = "copyright";    // of the same package

// Empty: the build had no such file.
std::string_view asset(std::string_view name);

} // namespace ffgpu::tools
