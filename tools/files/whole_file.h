// WholeFile: a file that is there whole or not at all. It is written under a name of its own beside
// the wanted one and takes its place in one step, so that a full disk, a limit or a crash in the
// middle leaves what was there before.

#pragma once

#include <cstdio>
#include <string>
#include <string_view>

namespace ffgpu::tools {

class WholeFile {
public:
    // Throws InputError, as all below, with the path and the system's reason.
    explicit WholeFile(std::string path);
    ~WholeFile(); // Without commit() nothing stays.
    WholeFile(const WholeFile&) = delete;
    WholeFile& operator=(const WholeFile&) = delete;

    // For libraries that write to one; what goes wrong there is found by commit().
    std::FILE* stream() { return stream_; }
    void write(std::string_view bytes);
    // The bytes are with the system, and the file has its name.
    void commit();

private:
    [[noreturn]] void fail(int reason);

    std::string path_;
    std::string temporary_;
    std::FILE* stream_ = nullptr;
};

} // namespace ffgpu::tools
