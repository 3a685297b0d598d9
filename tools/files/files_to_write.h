// The files that a command is asked to write, beside those that it reads.

#pragma once

#include <initializer_list>
#include <string>

namespace ffgpu::tools {

struct FileToWrite {
    const char* option;
    const std::string& path; // empty: none is written
};

// Throws InputError where one is a folder, or a file that is read, which would be gone, or two are
// one file: of two writers, neither's would be left. `read`: empty ones are none.
void check_files(std::initializer_list<std::string> read,
                 std::initializer_list<FileToWrite> written);

// The same of what a command writes to its folder, under names of its own: throws where one of
// `read`, or a link to it, lies there with a name of that kind. An empty folder: none is written.
void check_folder(std::initializer_list<std::string> read, const std::string& folder);

// Throws where `path`, of this option, has a name of that kind in the folder: what is written there
// is read from it, or written by another.
void check_outside(const char* option, const std::string& path, const std::string& folder);

} // namespace ffgpu::tools
