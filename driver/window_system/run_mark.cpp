#include "driver/window_system/run_mark.h"

#include <cstdlib>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace ffgpu::gl {
namespace {

constexpr const char* Variable = "FFGPU_MARK";
constexpr off_t DrawsAt = 0, FrameAt = 1;

int claimed = -1; // The file, open as long as the process lives: it has the lock.

int open_mark() {
    const char* const path = std::getenv(Variable);
    return path ? ::open(path, O_RDWR | O_CLOEXEC) : -1;
}

// Where the file is gone nobody wants to know.
void write_at(int file, off_t at) {
    if (::pwrite(file, "1", 1, at) != 1) return;
}

} // namespace

bool RunMark::is_there() {
    return std::getenv(Variable) != nullptr;
}

void RunMark::leave() {
    const int file = open_mark();
    if (file < 0) return;
    write_at(file, DrawsAt);
    ::close(file);
}

bool RunMark::claim() {
    const int file = open_mark();
    if (file < 0) return true;
    struct stat status {};
    const bool locked = ::flock(file, LOCK_EX | LOCK_NB) == 0;
    if (locked && ::fstat(file, &status) == 0 && status.st_size <= FrameAt) {
        claimed = file;
        return true;
    }
    ::close(file);
    return false;
}

void RunMark::leave_frame() {
    if (claimed >= 0) write_at(claimed, FrameAt);
}

} // namespace ffgpu::gl
