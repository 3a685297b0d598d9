// MadeFolder: a folder for what a command writes, made where it is missing. Where nothing came into
// it, what was made is taken back: a command that was refused leaves nothing.

#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace ffgpu::tools {

class MadeFolder {
public:
    // An empty path: there is none. Throws InputError where it cannot be made.
    explicit MadeFolder(const std::string& path);
    ~MadeFolder();
    MadeFolder(const MadeFolder&) = delete;
    MadeFolder& operator=(const MadeFolder&) = delete;

private:
    std::vector<std::filesystem::path> made_; // the innermost first
};

} // namespace ffgpu::tools
