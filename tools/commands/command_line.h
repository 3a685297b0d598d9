// The command line as a whole: parses, runs the verb, and turns what goes wrong into text and an
// exit status.

#pragma once

#include <functional>

namespace ffgpu::tools {

// 0: done. 1: a comparison failed. 2: bad input or usage. 3: the timed machine is stuck.
// Of `work`; what it throws is told on the standard error output.
int status_of(const std::function<int()>& work);

// The same of the verb that is named.
int run_command_line(int count, const char* const* arguments, const char* version);

} // namespace ffgpu::tools
