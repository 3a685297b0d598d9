// JobThread: a thread that does jobs in order, behind a bounded queue.
//
// What a job throws comes out of drain() or check_failure(); jobs handed over after it are dropped.

#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

namespace ffgpu::work {

class JobThread {
public:
    // Jobs wait up to a sum of weights; one fits always, however heavy it is.
    explicit JobThread(std::size_t most_weight);
    ~JobThread(); // Waits for the jobs, and drops what they throw.
    JobThread(const JobThread&) = delete;
    JobThread& operator=(const JobThread&) = delete;

    void push(std::size_t weight, std::function<void()> run);

    // Returns when all is done.
    void drain();
    // Throws what a job threw, once.
    void check_failure();

private:
    struct Job {
        std::size_t weight = 1;
        std::function<void()> run;
    };

    void work();
    void rethrow(std::unique_lock<std::mutex>& lock);

    const std::size_t most_weight_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Job> jobs_;
    std::size_t weight_ = 0; // of the jobs that wait
    bool busy_ = false;
    bool stopping_ = false;
    std::exception_ptr failure_;
    bool failed_ = false;
    std::thread thread_; // The last: it uses the others.
};

} // namespace ffgpu::work
