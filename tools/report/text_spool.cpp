#include "tools/report/text_spool.h"

#include "model/base/input_error.h"
#include "model/base/no_file_size_signal.h"

#include <array>

#include <unistd.h>

namespace ffgpu::tools {
namespace {

void require(bool done) {
    if (!done) throw InputError("the temporary file of the statistics fails: is the disk full?");
}

} // namespace

TextSpool::TextSpool()
    : file_(std::tmpfile()) {
    require(file_ != nullptr);
}

void TextSpool::append(std::string_view text) {
    const NoFileSizeSignal no_signal;
    while (!text.empty()) {
        const ssize_t written =
            ::pwrite(::fileno(file_.get()), text.data(), text.size(), static_cast<off_t>(size_));
        require(written > 0);
        size_ += static_cast<std::uint64_t>(written);
        text.remove_prefix(static_cast<std::size_t>(written));
    }
}

void TextSpool::copy_to(const TextSink& out) const {
    std::array<char, 65536> buffer;
    for (std::uint64_t at = 0; at < size_;) {
        const ssize_t read =
            ::pread(::fileno(file_.get()), buffer.data(), buffer.size(), static_cast<off_t>(at));
        require(read > 0);
        out({buffer.data(), static_cast<std::size_t>(read)});
        at += static_cast<std::uint64_t>(read);
    }
}

} // namespace ffgpu::tools
