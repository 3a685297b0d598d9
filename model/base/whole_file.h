// WholeFile: a file that is there whole or not at all. It is written under a name of its own beside
// the wanted one and takes its place in one step, so that a full disk, a limit or a crash in the
// middle leaves what was there before. A device or a pipe is written as it is.
//
// Nothing waits in the process: a child that it forks has nothing to write a second time.

#pragma once

#include "model/base/unfinished_file.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <sys/types.h>

namespace ffgpu {

// Of this process, beside the wanted one, which may be as long as a name can be.
std::string unfinished_name(const std::string& path);

class WholeFile {
public:
    // Throws InputError, as all below, with the path and the system's reason. A limit on the sizes
    // of files is such a reason, too, and no signal.
    explicit WholeFile(std::string path);
    ~WholeFile(); // Without commit() nothing stays.
    WholeFile(const WholeFile&) = delete;
    WholeFile& operator=(const WholeFile&) = delete;

    const std::string& path() const { return path_; }

    void write(std::span<const std::byte> bytes);
    void write(std::string_view text) { write(std::as_bytes(std::span(text))); }
    // The bytes are with the system, and the file has its name. Behind a write that failed neither
    // this nor another write does anything but fail for the same reason.
    void commit();

private:
    [[noreturn]] void fail(int reason) const;

    std::string path_;      // as it was given
    std::string target_;    // where links lead
    std::string temporary_; // empty: it is written in place
    std::optional<UnfinishedFile> unfinished_;
    int file_ = -1;
    int failure_ = 0; // of the first write that failed
    pid_t process_;
};

} // namespace ffgpu
