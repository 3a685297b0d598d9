// InputFile: a file read from front to back, in pieces.

#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <span>
#include <string>

namespace ffgpu::trace {

class InputFile {
public:
    // Throws InputError if the file cannot be opened, is a directory or a pipe, or is empty.
    explicit InputFile(const std::string& path);

    // Reads up to bytes.size() bytes; fewer only at the end of the file.
    std::size_t read(std::span<std::byte> bytes);
    void rewind();

    const std::string& path() const { return path_; }
    std::uint64_t position() const { return position_; }

private:
    struct Close {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };

    std::string path_;
    std::unique_ptr<std::FILE, Close> file_;
    std::uint64_t position_ = 0;
};

} // namespace ffgpu::trace
