#include "model/work/job_thread.h"

#include "model/base/thread_without_signals.h"

#include <utility>

namespace ffgpu::work {

JobThread::JobThread(std::size_t most_weight)
    : jobs_(most_weight)
    , thread_(thread_without_signals([this] { work(); })) {}

JobThread::~JobThread() {
    {
        const std::lock_guard lock(mutex_);
        stopping_ = true;
    }
    changed_.notify_all();
    thread_.join();
}

void JobThread::push(std::size_t weight, std::function<void()> run) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return jobs_.takes(weight); });
    jobs_.add(weight, std::move(run));
    changed_.notify_all();
}

void JobThread::drain() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return jobs_.is_done(); });
    jobs_.rethrow(lock);
}

void JobThread::check_failure() {
    std::unique_lock lock(mutex_);
    jobs_.rethrow(lock);
}

void JobThread::work() {
    std::unique_lock lock(mutex_);
    while (true) {
        changed_.wait(lock, [this] { return stopping_ || jobs_.is_ready(); });
        if (!jobs_.is_ready()) return;
        jobs_.run_first(lock, changed_);
    }
}

} // namespace ffgpu::work
