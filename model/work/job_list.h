// JobList: the jobs of one order that wait, and whether one is under way. Its owner's lock, and who
// waits for a change, are handed in.

#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>

namespace ffgpu::work {

class JobList {
public:
    explicit JobList(std::size_t most_weight)
        : most_weight_(most_weight) {}

    bool takes(std::size_t weight) const {
        return failed_ || jobs_.empty() || weight_ + weight <= most_weight_;
    }
    // Dropped, if a job failed.
    void add(std::size_t weight, std::function<void()> run);

    bool is_ready() const { return !busy_ && !jobs_.empty(); }
    bool has_more() const { return !jobs_.empty(); }
    bool is_done() const { return !busy_ && jobs_.empty(); }

    // Does the first job, without the lock; is_ready().
    void run_first(std::unique_lock<std::mutex>& lock, std::condition_variable& changed);
    // Throws what a job threw, once, without the lock.
    void rethrow(std::unique_lock<std::mutex>& lock);

private:
    struct Job {
        std::size_t weight = 1;
        std::function<void()> run;
    };

    const std::size_t most_weight_;
    std::deque<Job> jobs_;
    std::size_t weight_ = 0; // of the jobs that wait
    bool busy_ = false;
    std::exception_ptr failure_;
    bool failed_ = false;
};

} // namespace ffgpu::work
