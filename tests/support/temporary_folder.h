// An empty folder that is gone after the test.

#pragma once

#include <filesystem>
#include <string>

#include <unistd.h>

namespace ffgpu {

class TemporaryFolder {
public:
    TemporaryFolder()
        : path_(std::filesystem::temp_directory_path() /
                ("ffgpu_folder_" + std::to_string(::getpid()) + "_" + std::to_string(count_++))) {
        std::filesystem::create_directories(path_);
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    std::string path() const { return path_.string(); }
    std::string operator/(const std::string& name) const { return (path_ / name).string(); }

private:
    static inline unsigned count_ = 0;
    std::filesystem::path path_;
};

} // namespace ffgpu
