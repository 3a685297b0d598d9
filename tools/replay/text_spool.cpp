#include "tools/replay/text_spool.h"

#include "model/base/input_error.h"

#include <array>

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
    require(std::fwrite(text.data(), 1, text.size(), file_.get()) == text.size());
}

void TextSpool::copy_to(std::ostream& out) const {
    std::FILE* const file = file_.get();
    require(std::fflush(file) == 0 && std::fseek(file, 0, SEEK_SET) == 0);
    std::array<char, 65536> buffer;
    while (const std::size_t read = std::fread(buffer.data(), 1, buffer.size(), file))
        out.write(buffer.data(), static_cast<std::streamsize>(read));
    require(std::ferror(file) == 0 && std::fseek(file, 0, SEEK_END) == 0);
}

} // namespace ffgpu::tools
