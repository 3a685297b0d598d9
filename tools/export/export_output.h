// ExportOutput: where an export goes: a file that is there whole or not at all; or a pipe, a
// device, standard output, as it comes. Plain, or compressed. What was written does not stay in
// memory.

#pragma once

#include "model/base/whole_file.h"

#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

struct ZSTD_CCtx_s;

namespace ffgpu::tools {

class ExportOutput {
public:
    // "-": standard output. Throws InputError, as all below.
    ExportOutput(const std::string& path, bool compresses);
    ~ExportOutput();
    ExportOutput(const ExportOutput&) = delete;
    ExportOutput& operator=(const ExportOutput&) = delete;

    void write(std::string_view bytes);
    // All of it is with the system; the file has its name.
    void commit();

    // What was written has no name yet.
    bool is_file() const { return file_.has_value(); }

    // Before compression.
    std::uint64_t bytes() const { return bytes_; }

private:
    void compress(std::string_view bytes, bool last);
    void put(std::string_view bytes);

    [[noreturn]] void fail() const;

    struct FreeContext {
        void operator()(ZSTD_CCtx_s* context) const;
    };
    struct CloseStream {
        void operator()(std::FILE* stream) const;
    };

    std::string name_;
    std::optional<WholeFile> file_;
    std::unique_ptr<std::FILE, CloseStream> stream_; // without a file
    std::unique_ptr<ZSTD_CCtx_s, FreeContext> compressor_;
    std::vector<char> packed_;
    std::uint64_t bytes_ = 0;
};

} // namespace ffgpu::tools
