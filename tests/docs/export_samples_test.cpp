// The lines that docs/export.md shows of each format, against what ffgpu exports.

#include "tests/docs/text_file.h"

#include <cstdio>
#include <memory>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

namespace ffgpu::docs {
namespace {

constexpr std::string_view Indent = "    ", Verb = "ffgpu export traces/";

// A command and the lines that are shown of what it writes.
struct Sample {
    std::string command;
    std::vector<std::string> lines;
};

// Blocks are indented; one with a command is followed by what it writes.
std::vector<Sample> samples_of(const std::string& page) {
    std::vector<Sample> samples;
    std::istringstream text(page);
    bool in_command = false;
    for (std::string line; std::getline(text, line);) {
        if (line.starts_with("#")) in_command = false, samples.emplace_back();
        if (!line.starts_with(Indent)) {
            in_command = false;
            continue;
        }
        line.erase(0, Indent.size());
        if (line.starts_with(Verb)) {
            in_command = true;
            samples.push_back({line, {}});
        } else if (!in_command && !samples.empty()) {
            samples.back().lines.push_back(line);
        }
    }
    std::erase_if(samples, [](const Sample& one) { return one.command.empty(); });
    return samples;
}

// Waves are shown as text.
std::string printing(std::string command) {
    const std::size_t options = command.find(' ', Verb.size());
    const std::string input =
        FFGPU_SOURCE_DIR "/traces/" + command.substr(Verb.size(), options - Verb.size());
    std::string rest = command.substr(options, command.find(" -o ") - options);
    if (const std::size_t fst = rest.find(" fst"); fst != std::string::npos)
        rest.replace(fst, 4, " vcd");
    return FFGPU_BINARY " export '" + input + "'" + rest + " 2> /dev/null";
}

std::set<std::string> lines_of(const std::string& command) {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(::popen(command.c_str(), "r"),
                                                               ::pclose);
    std::string text;
    char bytes[4096];
    while (const std::size_t count = std::fread(bytes, 1, sizeof bytes, pipe.get()))
        text.append(bytes, count);
    std::istringstream stream(text);
    std::set<std::string> lines;
    for (std::string line; std::getline(stream, line);)
        lines.insert(line);
    return lines;
}

} // namespace

TEST_CASE("each line that docs/export.md shows is one that is exported") {
    const std::vector<Sample> samples = samples_of(read_source("docs/export.md"));
    std::size_t shown = 0;
    for (const Sample& sample : samples) {
        if (sample.lines.empty()) continue;
        const std::set<std::string> lines = lines_of(printing(sample.command));
        for (const std::string& line : sample.lines) {
            CAPTURE(sample.command, line);
            CHECK(lines.contains(line));
            ++shown;
        }
    }
    CHECK(shown >= 10);
}

} // namespace ffgpu::docs
