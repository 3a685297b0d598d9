// ThreadPool: runs the jobs of one list at a time on a fixed set of threads. The caller goes on in
// between, and takes jobs itself where it waits for them.

#pragma once

#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace ffgpu {

class ThreadPool {
public:
    // job(worker, index): worker 0 is the caller's thread.
    using Job = std::function<void(unsigned, std::size_t)>;

    explicit ThreadPool(unsigned threads);
    ~ThreadPool();
    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;

    unsigned threads() const { return static_cast<unsigned>(workers_.size()) + 1; }

    // The other threads begin to run `job` for each index below `count`. The list before must have
    // been waited for.
    void start(std::size_t count, Job job);
    // Returns when the job has run for each index. It waits for jobs, not for threads: one that
    // wakes late delays nobody. An exception of a job is thrown again here; jobs that had not begun
    // are left out then.
    void wait();
    // Both.
    void run(std::size_t count, Job job);

private:
    void work(unsigned worker);
    void take_jobs(unsigned worker);
    void end_job(std::exception_ptr failure);

    std::vector<std::thread> workers_;
    std::mutex mutex_; // over all below
    std::condition_variable started_, done_;
    Job job_;
    std::size_t count_ = 0;
    std::size_t next_ = 0;
    std::size_t running_ = 0; // jobs that have begun and not ended
    bool stopping_ = false;
    std::exception_ptr failure_;
};

} // namespace ffgpu
