// What a check found, for programs and for people.

#pragma once

#include "tools/check/check_suite.h"

#include <string>
#include <vector>

namespace ffgpu::tools {

// JUnit's XML, as servers of continuous integration read it: a suite a trace, a case a frame.
std::string junit_report(const std::string& suite, const std::vector<CheckedFrame>& frames);

// A page that stands in the output folder: a table of all frames, and what differs as three
// pictures side by side.
std::string html_report(const std::string& suite, const std::vector<CheckedFrame>& frames);

} // namespace ffgpu::tools
