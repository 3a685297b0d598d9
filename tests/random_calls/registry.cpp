#include "tests/random_calls/registry.h"

#include <fstream>
#include <set>
#include <sstream>

namespace ffgpu::gl {
namespace {

// The text between two others, from `at` on; empty where they are not there.
std::string between(const std::string& line, const std::string& before, const std::string& after) {
    const std::size_t begin = line.find(before);
    if (begin == std::string::npos) return {};
    const std::size_t from = begin + before.size(), to = line.find(after, from);
    return to == std::string::npos ? std::string() : line.substr(from, to - from);
}

using Groups = std::map<std::string, std::vector<GLuint>>;

// <enum value="0x0DE1" name="GL_TEXTURE_2D" group="EnableCap,TextureTarget"/>
void add_enumerant(const std::string& line, Groups& groups) {
    const std::string value = between(line, "value=\"", "\""),
                      names = between(line, "group=\"", "\"");
    if (value.empty() || names.empty()) return;
    std::istringstream list(names);
    for (std::string name; std::getline(list, name, ',');)
        groups[name].push_back(static_cast<GLuint>(std::stoull(value, nullptr, 0)));
}

// <param group="TextureTarget"><ptype>GLenum</ptype> <name>target</name></param>
RegistryParameter read_parameter(const std::string& line, const Groups& groups) {
    RegistryParameter parameter{.type = between(line, "<ptype>", "</ptype>"),
                                .name = between(line, "<name>", "</name>"),
                                .is_pointer = line.find('*') != std::string::npos};
    if (parameter.type.empty()) parameter.type = "void";
    const auto group = groups.find(between(line, "group=\"", "\""));
    if (group != groups.end()) parameter.values = group->second;
    return parameter;
}

} // namespace

Registry read_registry(const std::string& path) {
    Registry registry;
    std::ifstream file(path);
    Groups groups; // The enumerants come before the commands.
    std::vector<RegistryParameter>* command = nullptr;
    for (std::string line; std::getline(file, line);) {
        if (line.find("<enum ") != std::string::npos)
            add_enumerant(line, groups);
        else if (line.find("<proto") != std::string::npos)
            command = &registry.commands[between(line, "<name>", "</name>")];
        else if (command && line.find("<param") != std::string::npos)
            command->push_back(read_parameter(line, groups));
    }
    std::set<GLuint> values;
    for (const char* const name : {"TextureMinFilter",
                                   "TextureMagFilter",
                                   "TextureWrapMode",
                                   "TextureEnvMode",
                                   "TextureGenMode",
                                   "FogMode",
                                   "DepthFunction",
                                   "LightModelColorControl"})
        values.insert(groups[name].begin(), groups[name].end());
    registry.parameter_values.assign(values.begin(), values.end());
    return registry;
}

} // namespace ffgpu::gl
