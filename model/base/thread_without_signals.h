// A thread that takes none of the process' signals: a program's handlers do not run on threads that
// it does not know of, and a signal finds those of its own.

#pragma once

#include "model/base/large_pages.h"

#include <csignal>
#include <functional>
#include <thread>
#include <utility>

namespace ffgpu {

inline std::thread thread_without_signals(std::function<void()> run) {
    sigset_t all, before;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    std::thread thread([run = std::move(run)] {
        take_thread_heap_in_large_pages();
        run();
    });
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
    return thread;
}

} // namespace ffgpu
