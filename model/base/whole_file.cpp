#include "model/base/whole_file.h"

#include "model/base/input_error.h"
#include "model/base/no_file_size_signal.h"

#include <cerrno>
#include <climits>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <functional>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

namespace ffgpu {
namespace {

namespace fs = std::filesystem;

constexpr mode_t Rights = 0666; // less the process's mask

ssize_t write_some(int file, std::span<const std::byte> bytes) {
    const NoFileSizeSignal no_signal;
    ssize_t written = -1;
    do
        written = ::write(file, bytes.data(), bytes.size());
    while (written < 0 && errno == EINTR);
    return written;
}

} // namespace

std::string unfinished_name(const std::string& path) {
    constexpr std::size_t Longest = NAME_MAX - 8; // Some writers add an ending of their own.
    const std::string end = ".part" + std::to_string(::getpid());
    const fs::path wanted = path;
    const std::string name = wanted.filename().string();
    if (name.size() + end.size() <= Longest) return path + end;
    const std::string own = '-' + std::to_string(std::hash<std::string>{}(name)) + end;
    return wanted.parent_path() / (name.substr(0, Longest - own.size()) + own);
}

WholeFile::WholeFile(std::string path)
    : path_(std::move(path))
    , process_(::getpid()) {
    std::error_code error;
    target_ = fs::weakly_canonical(path_, error).string();
    if (error) fail(error.value());
    const fs::file_status status = fs::status(target_, error);
    const bool is_special = fs::exists(status) && !fs::is_regular_file(status);
    if (!is_special) temporary_ = unfinished_name(target_);
    const std::string& name = is_special ? target_ : temporary_;
    if (!is_special) unfinished_.emplace(temporary_);
    file_ = ::open(name.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, Rights);
    if (file_ < 0) fail(errno);
}

WholeFile::~WholeFile() {
    if (file_ < 0) return;
    ::close(file_);
    if (!temporary_.empty() && process_ == ::getpid()) ::unlink(temporary_.c_str());
}

void WholeFile::write(std::span<const std::byte> bytes) {
    if (process_ != ::getpid()) return; // A forked child's parent goes on writing.
    if (failure_ != 0) fail(failure_);
    while (!bytes.empty()) {
        const ssize_t written = write_some(file_, bytes);
        if (written < 0) fail(failure_ = errno);
        bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
}

void WholeFile::commit() {
    int reason = ::close(std::exchange(file_, -1)) == 0 ? 0 : errno;
    if (failure_ != 0) reason = failure_;
    if (temporary_.empty() && reason == 0) return;
    if (reason == 0 && std::rename(temporary_.c_str(), target_.c_str()) == 0) return;
    if (reason == 0) reason = errno;
    if (!temporary_.empty()) ::unlink(temporary_.c_str());
    fail(reason);
}

void WholeFile::fail(int reason) const {
    throw OutputError(path_ + ": cannot be written: " + std::strerror(reason));
}

} // namespace ffgpu
