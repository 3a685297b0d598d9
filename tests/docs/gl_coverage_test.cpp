// docs/gl_coverage.md leaves out no extension and no command, and names no test that is not there.

#include "driver/context/extensions.h"
#include "tests/docs/text_file.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <regex>
#include <sstream>
#include <string>

#include <catch2/catch.hpp>

namespace ffgpu::docs {
namespace {

struct Name {
    const char* name;
    const char* target; // of an alias; null: a command
};

constexpr Name Names[] = {
#define GL_COMMAND(result, name, parameters, arguments, command_class) {#name, nullptr},
#define GL_ALIAS(result, name, parameters, arguments, target) {#name, #target},
#include "driver/commands/commands.inc"
#undef GL_COMMAND
#undef GL_ALIAS
};

// The commands, and the other names of each in parentheses, of the rows of the page's index.
struct Index {
    std::map<std::string, std::string> file_of; // of a command
    std::map<std::string, std::string> aliases; // to the command
    unsigned rows = 0, names = 0;
};

Index read_index() {
    Index index;
    std::istringstream page(read_source("docs/gl_coverage.md"));
    const std::regex row(R"(^\| \[(\w+\.cpp)\]\(\.\./driver/api/\w+\.cpp\) \| (.*) \|$)");
    const std::regex name(R"((\()?(\w+)\)?)");
    for (std::string line; std::getline(page, line);) {
        std::smatch parts;
        if (!std::regex_match(line, parts, row)) continue;
        ++index.rows;
        const std::string names = parts[2];
        std::string command;
        for (std::sregex_iterator i(names.begin(), names.end(), name), end; i != end; ++i) {
            ++index.names;
            if ((*i)[1].matched) {
                index.aliases[(*i)[2]] = command;
            } else {
                command = (*i)[2];
                index.file_of[command] = parts[1];
            }
        }
    }
    return index;
}

} // namespace

TEST_CASE("each advertised extension stands in docs/gl_coverage.md") {
    const std::string page = read_source("docs/gl_coverage.md");
    for (const std::string_view extension : gl::Extensions) {
        INFO(extension);
        CHECK(std::regex_search(page, std::regex(std::string(extension) + "\\b")));
    }
}

TEST_CASE("each extension in docs/gl_coverage.md is advertised") {
    const std::string page = read_source("docs/gl_coverage.md");
    const std::regex extension(
        R"(\bGL_(3DFX|ARB|EXT|ATI|NV|SGIS|S3|IBM|MESA|APPLE|GREMEDY|OES)_\w+)");
    for (std::sregex_iterator i(page.begin(), page.end(), extension), end; i != end; ++i) {
        INFO(i->str());
        CHECK(std::find(gl::Extensions.begin(), gl::Extensions.end(), i->str()) !=
              gl::Extensions.end());
    }
}

TEST_CASE("each test file that docs/gl_coverage.md names exists") {
    const std::string page = read_source("docs/gl_coverage.md");
    const std::regex file(R"((tests/\w+/)?\w+_test\.cpp)");
    unsigned count = 0;
    for (std::sregex_iterator i(page.begin(), page.end(), file), end; i != end; ++i, ++count) {
        const std::string path = (*i)[1].matched ? i->str() : "tests/driver/" + i->str();
        INFO(path);
        CHECK(std::filesystem::exists(std::string(FFGPU_SOURCE_DIR "/") + path));
    }
    CHECK(count > 50);
}

TEST_CASE("every command stands once in the index, with the file that defines it") {
    INFO("tests/docs/command_index.py writes the index anew");
    const Index index = read_index();
    for (const auto& [name, target] : Names) {
        INFO(name);
        if (target == nullptr)
            CHECK(index.file_of.count(name) == 1);
        else
            CHECK((index.aliases.count(name) == 1 && index.aliases.at(name) == target));
    }
    CHECK(index.names == std::size(Names));

    // A macro defines families of commands: what stands in the file is the name up to its number.
    for (const auto& [command, file] : index.file_of) {
        INFO(command << " in driver/api/" << file);
        const std::string stem = std::regex_replace(command,
                                                    std::regex("([1-4]?(b|s|i|f|d|ub|us|ui)v?"
                                                               "|[1-4]?)(MESA)?$"),
                                                    "");
        CHECK(read_source("driver/api/" + file).find(stem) != std::string::npos);
    }
}

} // namespace ffgpu::docs
