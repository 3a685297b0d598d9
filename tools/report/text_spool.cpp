#include "tools/report/text_spool.h"

#include "model/base/input_error.h"
#include "model/base/no_file_size_signal.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <string>

#include <unistd.h>

namespace ffgpu::tools {
namespace {

[[noreturn]] void fail(const std::string& what) {
    throw InputError("a temporary file of the statistics, in " P_tmpdir ": cannot be " + what);
}

void require(bool done, const char* what) {
    if (!done) fail(what + std::string(": ") + std::strerror(errno));
}

} // namespace

TextSpool::TextSpool()
    : file_(std::tmpfile()) {
    require(file_ != nullptr, "made");
}

void TextSpool::append(std::string_view text) {
    const NoFileSizeSignal no_signal;
    while (!text.empty()) {
        const ssize_t written =
            ::pwrite(::fileno(file_.get()), text.data(), text.size(), static_cast<off_t>(size_));
        require(written > 0, "written");
        size_ += static_cast<std::uint64_t>(written);
        text.remove_prefix(static_cast<std::size_t>(written));
    }
}

void TextSpool::copy_to(const TextSink& out) const {
    std::array<char, 65536> buffer;
    for (std::uint64_t at = 0; at < size_;) {
        const ssize_t read =
            ::pread(::fileno(file_.get()), buffer.data(), buffer.size(), static_cast<off_t>(at));
        if (read == 0) fail("read: it is shorter than it was");
        require(read > 0, "read");
        out({buffer.data(), static_cast<std::size_t>(read)});
        at += static_cast<std::uint64_t>(read);
    }
}

} // namespace ffgpu::tools
