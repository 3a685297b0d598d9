#include "model/gpu/thread_pool.h"

#include "model/base/check.h"
#include "model/base/float_environment.h"
#include "model/base/thread_without_signals.h"

#include <utility>

namespace ffgpu {

ThreadPool::ThreadPool(unsigned threads) {
    for (unsigned worker = 1; worker < threads; ++worker)
        workers_.push_back(thread_without_signals([this, worker] { work(worker); }));
}

ThreadPool::~ThreadPool() {
    {
        const std::lock_guard lock(mutex_);
        stopping_ = true;
    }
    started_.notify_all();
    for (std::thread& worker : workers_)
        worker.join();
}

void ThreadPool::start(std::size_t count, Job job) {
    {
        const std::lock_guard lock(mutex_);
        check(next_ >= count_ && running_ == 0, "a list of jobs is under way");
        job_ = std::move(job);
        count_ = count;
        next_ = 0;
    }
    started_.notify_all();
}

void ThreadPool::wait() {
    take_jobs(0);
    std::unique_lock lock(mutex_);
    done_.wait(lock, [this] { return running_ == 0; });
    if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
}

void ThreadPool::run(std::size_t count, Job job) {
    start(count, std::move(job));
    wait();
}

void ThreadPool::take_jobs(unsigned worker) {
    while (true) {
        std::size_t index = 0;
        {
            const std::lock_guard lock(mutex_);
            if (next_ >= count_) return;
            index = next_++;
            ++running_;
        }
        std::exception_ptr failure;
        try {
            job_(worker, index); // The same until all that have begun have ended.
        } catch (...) {
            failure = std::current_exception();
        }
        end_job(std::move(failure));
    }
}

void ThreadPool::end_job(std::exception_ptr failure) {
    const std::lock_guard lock(mutex_);
    if (failure) {
        if (!failure_) failure_ = std::move(failure);
        next_ = count_;
    }
    if (--running_ == 0 && next_ >= count_) done_.notify_one();
}

void ThreadPool::work(unsigned worker) {
    const FloatEnvironment environment; // A thread begins with the mode of the one that made it.
    while (true) {
        {
            std::unique_lock lock(mutex_);
            started_.wait(lock, [this] { return stopping_ || next_ < count_; });
            if (stopping_) return;
        }
        take_jobs(worker);
    }
}

} // namespace ffgpu
