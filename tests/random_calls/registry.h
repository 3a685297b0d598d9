// The Khronos registry's knowledge of parameters: what kind of value each one takes.

#pragma once

#include "driver/gl_types.h"

#include <map>
#include <string>
#include <vector>

namespace ffgpu::gl {

struct RegistryParameter {
    std::string type; // "GLenum", "GLsizei", "void", "GLfloat" ...
    std::string name;
    bool is_pointer = false;
    std::vector<GLuint> values{}; // of the parameter's group of enumerants; empty: it has none
};

struct Registry {
    // By the commands' names, "glTexImage2D".
    std::map<std::string, std::vector<RegistryParameter>> commands;
    // What the many glThing*(pname, param) take where their param is an enumerant.
    std::vector<GLuint> parameter_values;

    bool empty() const { return commands.empty(); }
};

// Reads gl.xml; an empty registry where there is no such file.
Registry read_registry(const std::string& path);

} // namespace ffgpu::gl
