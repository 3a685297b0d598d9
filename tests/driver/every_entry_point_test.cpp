// Every command of OpenGL 1.0 to 1.5, as the Khronos registry lists them, has its entry point here;
// that each is defined is what the linker finds.

#include "driver/entry_points/entry.h"

#include <algorithm>
#include <fstream>
#include <iostream>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

namespace entry = ffgpu::gl::entry;

namespace {

struct EntryPoint {
    std::string name;
    const void* address;
};

const std::vector<EntryPoint>& entry_points() {
    static const std::vector<EntryPoint> all{
#define GL_COMMAND(result, name, parameters, arguments, command_class)                             \
    {"gl" #name, reinterpret_cast<const void*>(&entry::name)},
#define GL_ALIAS(result, name, parameters, arguments, target)                                      \
    {"gl" #name, reinterpret_cast<const void*>(&entry::name)},
#include "driver/commands/commands.inc"
#undef GL_COMMAND
#undef GL_ALIAS
    };
    return all;
}

// The commands that the registry's features GL_VERSION_1_0 to GL_VERSION_1_5 require.
std::vector<std::string> registry_commands(const std::string& xml) {
    const std::regex command("<command name=\"(gl\\w+)\"");
    std::vector<std::string> names;
    std::size_t at = 0;
    // One feature after the other: std::regex recurses along what it matches.
    while ((at = xml.find(R"(<feature api="gl" name="GL_VERSION_1_)", at)) != std::string::npos) {
        const std::string body = xml.substr(at, xml.find("</feature>", at) - at);
        for (std::sregex_iterator i(body.begin(), body.end(), command), end; i != end; ++i)
            names.push_back((*i)[1]);
        at += body.size();
    }
    return names;
}

} // namespace

TEST_CASE("every command of OpenGL 1.0 to 1.5 has an entry point") {
    std::ifstream file("/usr/share/khronos-api/gl.xml");
    if (!file) {
        std::cout << "skipped: /usr/share/khronos-api/gl.xml (package khronos-api) is missing\n";
        return;
    }
    const std::string xml{std::istreambuf_iterator<char>(file), {}};
    const std::vector<std::string> wanted = registry_commands(xml);
    REQUIRE(wanted.size() > 400);
    for (const std::string& name : wanted) {
        INFO(name);
        CHECK(std::any_of(entry_points().begin(), entry_points().end(), [&](const auto& point) {
            return point.name == name && point.address != nullptr;
        }));
    }
}

TEST_CASE("without a current context a call does nothing and returns zero") {
    entry::Begin(GL_TRIANGLES);
    entry::Vertex3f(1, 2, 3);
    entry::End();
    CHECK(entry::GetError() == GL_NO_ERROR);
    CHECK(entry::GetString(GL_VERSION) == nullptr);
    CHECK(entry::GenLists(3) == 0);
}
