// NoFileSizeSignal: while it lives, a file that becomes too large is an error of write(2) and does
// not end the process: the thread keeps the signal back, and takes it away.

#pragma once

#include <cerrno>
#include <csignal>
#include <ctime>

namespace ffgpu {

class NoFileSizeSignal {
public:
    NoFileSizeSignal() {
        ::sigemptyset(&signal_);
        ::sigaddset(&signal_, SIGXFSZ);
        ::pthread_sigmask(SIG_BLOCK, &signal_, &before_);
    }
    ~NoFileSizeSignal() {
        const int error = errno;
        const timespec at_once{};
        if (!::sigismember(&before_, SIGXFSZ)) ::sigtimedwait(&signal_, nullptr, &at_once);
        ::pthread_sigmask(SIG_SETMASK, &before_, nullptr);
        errno = error;
    }
    NoFileSizeSignal(const NoFileSizeSignal&) = delete;
    NoFileSizeSignal& operator=(const NoFileSizeSignal&) = delete;

private:
    sigset_t signal_{}, before_{};
};

} // namespace ffgpu
