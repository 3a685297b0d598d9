#include "tools/commands/unused_reason.h"

#include <array>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <elf.h>

namespace ffgpu::tools {
namespace {

namespace fs = std::filesystem;

fs::path find_program(const std::string& name) {
    if (name.find('/') != std::string::npos) return name;
    const char* const variable = std::getenv("PATH");
    std::istringstream folders(variable ? variable : "");
    for (std::string folder; std::getline(folders, folder, ':');)
        if (std::error_code ignored; fs::is_regular_file(fs::path(folder) / name, ignored))
            return fs::path(folder) / name;
    return name;
}

// A 64-bit ELF program without an interpreter: no library of the system's is ever loaded into it.
bool is_static(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    Elf64_Ehdr header{};
    if (!file.read(reinterpret_cast<char*>(&header), sizeof header) ||
        std::memcmp(header.e_ident, ELFMAG, SELFMAG) != 0 || header.e_ident[EI_CLASS] != ELFCLASS64)
        return false;
    for (unsigned i = 0; i < header.e_phnum; ++i) {
        Elf64_Phdr segment{};
        file.seekg(static_cast<std::streamoff>(header.e_phoff + i * sizeof segment));
        if (!file.read(reinterpret_cast<char*>(&segment), sizeof segment)) return false;
        if (segment.p_type == PT_INTERP) return false;
    }
    return true;
}

std::string reason(const fs::path& path, int status) {
    std::error_code error;
    const fs::perms rights = fs::status(path, error).permissions();
    if (!error && (rights & (fs::perms::set_uid | fs::perms::set_gid)) != fs::perms::none)
        return "it runs with the rights of another user or group, for which the system ignores "
               "LD_LIBRARY_PATH; run a copy of it without the set-id bit";
    if (is_static(path)) return "it is linked statically";
    const std::string ended =
        status == 0 ? "" : "it ended before, with status " + std::to_string(status) + ", or ";
    return ended + "it draws otherwise than by OpenGL on GLX or EGL, or cleared its environment, "
                   "or another program drew that it started without its environment, or not before "
                   "its own end";
}

} // namespace

std::string unused_reason(const std::string& program, int status) {
    return program + " made no OpenGL context on ffgpu: " + reason(find_program(program), status);
}

} // namespace ffgpu::tools
