// UnfinishedFile: the name of a file that this process is writing and has not given its own name
// yet, so that whoever ends the process at once, from a signal's handler, takes it away before.

#pragma once

#include <string>

namespace ffgpu {

class UnfinishedFile {
public:
    // Before the file is there. Of more names at a time than a process has use for, some dozens,
    // and of such as no file can have, none is kept.
    explicit UnfinishedFile(const std::string& path) noexcept;
    ~UnfinishedFile(); // It has its own name, or is gone.
    UnfinishedFile(const UnfinishedFile&) = delete;
    UnfinishedFile& operator=(const UnfinishedFile&) = delete;

    // Removes all files of this process, not those that a forked child inherited.
    // Async-signal-safe; the process has to end after it.
    static void remove_all() noexcept;

private:
    struct Place;
    static Place places_[];

    Place* place_ = nullptr; // null: it was not kept
};

} // namespace ffgpu
