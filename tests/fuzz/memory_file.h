// A file that lives in memory alone, with a path.

#pragma once

#include "tests/fuzz/fuzz_target.h"

#include <cstdlib>
#include <string>
#include <vector>

#include <sys/mman.h>
#include <unistd.h>

namespace ffgpu::fuzz {

class MemoryFile {
public:
    explicit MemoryFile(Bytes bytes)
        : file_(::memfd_create("fuzz", 0)) {
        if (file_ < 0 ||
            ::write(file_, bytes.data(), bytes.size()) != static_cast<ssize_t>(bytes.size()))
            std::abort();
    }
    ~MemoryFile() { ::close(file_); }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    std::string path() const { return "/proc/self/fd/" + std::to_string(file_); }

private:
    int file_;
};

} // namespace ffgpu::fuzz
