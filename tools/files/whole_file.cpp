#include "tools/files/whole_file.h"

#include "model/base/input_error.h"

#include <cerrno>
#include <cstring>
#include <utility>

#include <unistd.h>

namespace ffgpu::tools {

WholeFile::WholeFile(std::string path)
    : path_(std::move(path))
    , temporary_(path_ + ".part" + std::to_string(::getpid())) {
    stream_ = std::fopen(temporary_.c_str(), "wbe");
    if (!stream_) fail(errno);
}

WholeFile::~WholeFile() {
    if (!stream_) return;
    std::fclose(stream_);
    std::remove(temporary_.c_str());
}

void WholeFile::write(std::string_view bytes) {
    if (std::fwrite(bytes.data(), 1, bytes.size(), stream_) != bytes.size()) fail(errno);
}

void WholeFile::commit() {
    const bool failed = std::ferror(stream_) != 0;
    errno = failed ? EIO : 0; // Unless closing it knows the reason.
    const bool closed = std::fclose(std::exchange(stream_, nullptr)) == 0;
    if (failed || !closed || std::rename(temporary_.c_str(), path_.c_str()) != 0) {
        const int reason = errno;
        std::remove(temporary_.c_str());
        fail(reason);
    }
}

void WholeFile::fail(int reason) {
    throw InputError(path_ + ": cannot be written: " + std::strerror(reason));
}

} // namespace ffgpu::tools
