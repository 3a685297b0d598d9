// A file with given bytes that is gone after the test.

#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include <unistd.h>

namespace ffgpu {

class TemporaryFile {
public:
    explicit TemporaryFile(const std::string& bytes, const std::string& extension = ".trace")
        : path_(std::filesystem::temp_directory_path() /
                ("ffgpu_test_" + std::to_string(::getpid()) + "_" + std::to_string(count_++) +
                 extension)) {
        std::ofstream(path_, std::ios::binary) << bytes;
    }
    ~TemporaryFile() {
        std::error_code ignored;
        std::filesystem::remove(path_, ignored);
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    std::string path() const { return path_.string(); }

private:
    static inline unsigned count_ = 0;
    std::filesystem::path path_;
};

} // namespace ffgpu
