#include "driver/trace/reader/input_file.h"

#include "model/base/input_error.h"

#include <cerrno>
#include <cstring>
#include <filesystem>

namespace ffgpu::trace {

InputFile::InputFile(const std::string& path)
    : path_(path)
    , file_(std::fopen(path.c_str(), "rb")) {
    if (!file_) throw InputError(path + ": cannot be opened: " + std::strerror(errno));
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored))
        throw InputError(path + ": is a directory; a trace file was expected");
    // A trace is read from its beginning more than once.
    if (std::fseek(file_.get(), 0, SEEK_SET) != 0)
        throw InputError(path + ": is a pipe or a terminal; a file was expected");
    const int first = std::fgetc(file_.get());
    if (first == EOF)
        throw InputError(path + ": byte 0: is empty; a trace or a capture was expected");
    std::ungetc(first, file_.get());
}

std::size_t InputFile::read(std::span<std::byte> bytes) {
    const std::size_t count = std::fread(bytes.data(), 1, bytes.size(), file_.get());
    position_ += count;
    return count;
}

void InputFile::rewind() {
    std::rewind(file_.get());
    position_ = 0;
}

} // namespace ffgpu::trace
