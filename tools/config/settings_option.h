// The option --set NAME=VALUE, the same of every verb.

#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace ffgpu::tools {

void add_settings_option(CLI::App& verb, std::vector<std::string>& settings);

// Of a command line: "--set A.B=1 C.D=2 INPUT" as "--set A.B=1 --set C.D=2 INPUT". Words that have
// the form of a setting go with the option, and no others do; behind "--" all is as it was.
std::vector<std::string> spread_settings(const std::vector<std::string>& words);

} // namespace ffgpu::tools
