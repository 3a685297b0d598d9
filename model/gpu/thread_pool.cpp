#include "model/gpu/thread_pool.h"

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

void ThreadPool::run(std::size_t count, const Job& job) {
    if (workers_.empty() || count <= 1) {
        for (std::size_t i = 0; i < count; ++i)
            job(0, i);
        return;
    }
    {
        const std::lock_guard lock(mutex_);
        job_ = &job;
        count_ = count;
        next_ = 0;
        busy_ = static_cast<unsigned>(workers_.size());
        ++generation_;
    }
    started_.notify_all();
    take_jobs(0);
    std::unique_lock lock(mutex_);
    done_.wait(lock, [this] { return busy_ == 0; });
    if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
}

void ThreadPool::take_jobs(unsigned worker) {
    while (true) {
        std::size_t index = 0;
        {
            const std::lock_guard lock(mutex_);
            if (next_ >= count_) return;
            index = next_++;
        }
        try {
            (*job_)(worker, index);
        } catch (...) {
            const std::lock_guard lock(mutex_);
            if (!failure_) failure_ = std::current_exception();
            next_ = count_;
        }
    }
}

void ThreadPool::work(unsigned worker) {
    const FloatEnvironment environment; // A thread begins with the mode of the one that made it.
    std::uint64_t seen = 0;
    while (true) {
        {
            std::unique_lock lock(mutex_);
            started_.wait(lock, [&] { return stopping_ || generation_ != seen; });
            if (stopping_) return;
            seen = generation_;
        }
        take_jobs(worker);
        {
            const std::lock_guard lock(mutex_);
            if (--busy_ == 0) done_.notify_one();
        }
    }
}

} // namespace ffgpu
