#include "model/work/job_thread.h"

#include "model/base/thread_without_signals.h"

#include <utility>

namespace ffgpu::work {

JobThread::JobThread(std::size_t most_weight)
    : most_weight_(most_weight)
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
    changed_.wait(lock,
                  [&] { return failed_ || jobs_.empty() || weight_ + weight <= most_weight_; });
    if (failed_) return;
    weight_ += weight;
    jobs_.push_back({weight, std::move(run)});
    changed_.notify_all();
}

void JobThread::drain() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return jobs_.empty() && !busy_; });
    rethrow(lock);
}

void JobThread::check_failure() {
    std::unique_lock lock(mutex_);
    rethrow(lock);
}

void JobThread::rethrow(std::unique_lock<std::mutex>& lock) {
    if (!failure_) return;
    const std::exception_ptr failure = std::exchange(failure_, nullptr);
    lock.unlock();
    std::rethrow_exception(failure);
}

void JobThread::work() {
    std::unique_lock lock(mutex_);
    while (true) {
        changed_.wait(lock, [this] { return stopping_ || !jobs_.empty(); });
        if (jobs_.empty()) return;
        Job job = std::move(jobs_.front());
        jobs_.pop_front();
        weight_ -= job.weight;
        busy_ = true;
        changed_.notify_all();
        lock.unlock();
        std::exception_ptr failure;
        try {
            job.run();
        } catch (...) {
            failure = std::current_exception();
        }
        job.run = nullptr; // A bin may go with it: not under the lock.
        lock.lock();
        busy_ = false;
        if (failure && !failed_) {
            failure_ = failure;
            failed_ = true;
            jobs_.clear();
            weight_ = 0;
        }
        changed_.notify_all();
    }
}

} // namespace ffgpu::work
