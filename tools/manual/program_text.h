// ProgramText: verbs and options as the command line defines them, for those who tell of them:
// completions of shells, manual pages.

#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace ffgpu::tools {

struct OptionText {
    std::vector<std::string> names;   // "-o", "--output"; of a positional one its name
    std::string value;                // "DIR"; of a flag empty
    std::vector<std::string> choices; // what the value is one of, or begins with
    std::string description;
    bool is_positional = false;
    bool is_required = false;

    bool is_folder() const { return value == "DIR"; }
    // The value is no file.
    bool is_number() const { return value == "N" || value == "X" || value == "A-B"; }
};

struct VerbText {
    std::string name, description, footer;
    std::vector<OptionText> options;
};

struct ProgramText {
    std::string description, footer, version;
    std::vector<OptionText> options; // before a verb
    std::vector<VerbText> verbs;
};

ProgramText program_text(const CLI::App& application);

} // namespace ffgpu::tools
