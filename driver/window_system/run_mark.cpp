#include "driver/window_system/run_mark.h"

#include <array>
#include <chrono>
#include <cstdlib>
#include <thread>

#include <fcntl.h>
#include <pthread.h>
#include <sys/file.h>
#include <unistd.h>

namespace ffgpu::gl {
namespace {

constexpr const char* Variable = "FFGPU_MARK";
constexpr off_t DrawsAt = 0, FrameAt = 1, BegunAt = 2, CompleteAt = 3, Size = 4;

// Those of the file's bytes that say yes; none where it cannot be read.
std::array<bool, Size> said(int file) {
    std::array<char, Size> bytes{};
    if (::pread(file, bytes.data(), bytes.size(), 0) < 0) bytes = {};
    std::array<bool, Size> yes{};
    for (std::size_t i = 0; i < bytes.size(); ++i)
        yes[i] = bytes[i] == '1';
    return yes;
}

int claimed = -1; // The file, open as long as the process lives: it has the lock.

// A child that this process forks is not the one that is recorded, and may outlive it.
void forget_claim() {
    ::close(claimed);
    claimed = -1;
}

int open_mark() {
    const char* const path = std::getenv(Variable);
    return path ? ::open(path, O_RDWR | O_CLOEXEC) : -1;
}

// Somebody has the lock, and not only until it runs: a child that was just forked has it, too,
// until then, and its parent may have ended.
bool stays_locked(int file) {
    constexpr std::chrono::milliseconds Pause(10), Longest(1000);
    for (auto waited = Pause; ::flock(file, LOCK_SH | LOCK_NB) != 0; waited += Pause) {
        if (waited > Longest) return true;
        std::this_thread::sleep_for(Pause);
    }
    return false;
}

// Where the file is gone nobody wants to know.
void write_at(int file, off_t at, const char* byte = "1") {
    if (::pwrite(file, byte, 1, at) != 1) return;
}

} // namespace

bool RunMark::is_there() {
    return std::getenv(Variable) != nullptr;
}

std::string RunMark::blank() {
    return std::string(Size, '0');
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
    const bool locked = ::flock(file, LOCK_EX | LOCK_NB) == 0;
    if (locked && !said(file)[FrameAt]) {
        claimed = file;
        ::pthread_atfork(nullptr, nullptr, forget_claim);
        write_at(file, BegunAt);
        write_at(file, CompleteAt, "0"); // Another's, who ended without a frame.
        return true;
    }
    ::close(file);
    return false;
}

void RunMark::leave_frame() {
    if (claimed >= 0) write_at(claimed, FrameAt);
}

void RunMark::leave_complete() {
    if (claimed >= 0) write_at(claimed, CompleteAt);
}

bool RunMark::is_over() {
    const char* const path = std::getenv(Variable);
    return path && ::access(path, F_OK) != 0;
}

RunMark::State RunMark::read(const std::string& path) {
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0) return {};
    const bool goes_on = stays_locked(file);
    const auto yes = said(file);
    const State state{
        .draws = yes[DrawsAt], .complete = yes[CompleteAt] || !yes[BegunAt], .goes_on = goes_on};
    ::close(file);
    return state;
}

} // namespace ffgpu::gl
