// TextWriter: text that is put together in memory and goes out in large pieces.

#pragma once

#include "tools/export/export_output.h"

#include <fmt/compile.h>
#include <fmt/format.h>

namespace ffgpu::tools {

class TextWriter {
public:
    explicit TextWriter(ExportOutput& out)
        : out_(out) {}

    // `format`: by FMT_COMPILE.
    template <class Format, class... Values>
    void print(const Format& format, const Values&... values) {
        fmt::format_to(fmt::appender(text_), format, values...);
        if (text_.size() >= Piece) flush();
    }

    void flush() {
        out_.write({text_.data(), text_.size()});
        text_.clear();
    }

private:
    static constexpr std::size_t Piece = std::size_t{1} << 18;

    ExportOutput& out_;
    fmt::memory_buffer text_;
};

} // namespace ffgpu::tools
