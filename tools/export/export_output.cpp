#include "tools/export/export_output.h"

#include "model/base/check.h"
#include "model/base/input_error.h"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include <zstd.h>

namespace ffgpu::tools {
namespace {

constexpr int CompressionLevel = 3;

// What may be replaced by another file.
bool is_plain_file(const std::string& path) {
    std::error_code ignored;
    return path != "-" && (!std::filesystem::exists(path, ignored) ||
                           std::filesystem::is_regular_file(path, ignored));
}

// The thread that writes may hold signals back (thread_without_signals): the one that tells that
// nobody reads any more is to end the program as it does elsewhere.
void take_broken_pipe_signal() {
    sigset_t signal;
    sigemptyset(&signal);
    sigaddset(&signal, SIGPIPE);
    pthread_sigmask(SIG_UNBLOCK, &signal, nullptr);
}

} // namespace

void ExportOutput::FreeContext::operator()(ZSTD_CCtx_s* context) const {
    ZSTD_freeCCtx(context);
}

void ExportOutput::CloseStream::operator()(std::FILE* stream) const {
    if (stream != stdout) std::fclose(stream);
}

ExportOutput::ExportOutput(const std::string& path, bool compresses)
    : name_(path == "-" ? "standard output" : path) {
    if (is_plain_file(path)) {
        file_.emplace(path);
    } else {
        stream_.reset(path == "-" ? stdout : std::fopen(path.c_str(), "wbe"));
        if (!stream_) fail();
    }
    if (!compresses) return;
    compressor_.reset(ZSTD_createCCtx());
    check(compressor_ != nullptr, "zstd has memory");
    ZSTD_CCtx_setParameter(compressor_.get(), ZSTD_c_compressionLevel, CompressionLevel);
    ZSTD_CCtx_setParameter(compressor_.get(), ZSTD_c_checksumFlag, 1);
    packed_.resize(ZSTD_CStreamOutSize());
}

ExportOutput::~ExportOutput() = default;

void ExportOutput::write(std::string_view bytes) {
    bytes_ += bytes.size();
    compressor_ ? compress(bytes, false) : put(bytes);
}

void ExportOutput::compress(std::string_view bytes, bool last) {
    ZSTD_inBuffer in{bytes.data(), bytes.size(), 0};
    for (bool over = false; !over;) {
        ZSTD_outBuffer out{packed_.data(), packed_.size(), 0};
        const std::size_t left =
            ZSTD_compressStream2(compressor_.get(), &out, &in, last ? ZSTD_e_end : ZSTD_e_continue);
        check(!ZSTD_isError(left), "zstd compresses anything");
        put({packed_.data(), out.pos});
        over = last ? left == 0 : in.pos == in.size;
    }
}

void ExportOutput::put(std::string_view bytes) {
    if (file_) return file_->write(bytes);
    if (std::fwrite(bytes.data(), 1, bytes.size(), stream_.get()) != bytes.size()) fail();
}

void ExportOutput::commit() {
    if (compressor_) compress({}, true);
    if (file_) return file_->commit();
    if (std::fflush(stream_.get()) != 0) fail();
}

void ExportOutput::fail() const {
    const int error = errno;
    if (error == EPIPE) take_broken_pipe_signal();
    throw InputError(name_ + ": cannot be written: " + std::strerror(error));
}

} // namespace ffgpu::tools
