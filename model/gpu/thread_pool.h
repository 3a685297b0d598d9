// ThreadPool: runs the jobs of one list at a time on a fixed set of threads, the caller's included.

#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
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

    // Returns when job has run for each index below `count`. An exception of a job is thrown again
    // here, after all threads have stopped.
    void run(std::size_t count, const Job& job);

private:
    void work(unsigned worker);
    void take_jobs(unsigned worker);

    std::vector<std::thread> workers_;
    std::mutex mutex_;
    std::condition_variable started_, done_;
    const Job* job_ = nullptr;
    std::size_t count_ = 0;
    std::size_t next_ = 0;         // under mutex_
    std::uint64_t generation_ = 0; // counts calls of run()
    unsigned busy_ = 0;            // workers that have not ended this generation
    bool stopping_ = false;
    std::exception_ptr failure_;
};

} // namespace ffgpu
