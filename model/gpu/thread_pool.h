// ThreadPool: runs the jobs of one list at a time on a fixed set of threads. The caller goes on in
// between, and takes jobs itself where it waits for them.

#pragma once

#include "model/gpu/thread_benefit.h"

#include <atomic>
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

    // `may_share`: asked before jobs are shared; null: always.
    explicit ThreadPool(unsigned threads, std::function<bool()> may_share = nullptr);
    ~ThreadPool();
    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;

    unsigned threads() const { return static_cast<unsigned>(workers_.size()) + 1; }

    // Whether other threads would take part in what begins now.
    bool shares() const {
        return !workers_.empty() && benefit_.pays(ThreadBenefit::Clock::now()) &&
               (!may_share_ || may_share_());
    }

    // The other threads begin to run `job` for each index below `count`; where there are none, or
    // where they do not share(), the caller has run all when this returns. The list before
    // must have been waited for.
    void start(std::size_t count, Job job);
    // Whether nothing is under way.
    bool done() const { return left_ == 0; }
    // Returns when the job has run for each index. It waits for jobs, not for threads: one that
    // wakes late delays nobody. An exception of a job is thrown again here; jobs that had not begun
    // are left out then.
    void wait();
    // Both.
    void run(std::size_t count, Job job);

private:
    // Indices from `next` up to `count` have not begun: both in one word, so that they are looked
    // at and taken together. So aligned that every compiler does that without a library's lock.
    struct alignas(std::uint64_t) Tickets {
        std::uint32_t next = 0, count = 0;
    };

    void work(unsigned worker);
    void run_alone(std::size_t count);
    void take_jobs(unsigned worker);
    void wait_for_others();
    bool take(std::size_t& index);
    void end_jobs(std::size_t ended);
    void keep_failure(std::exception_ptr failure);
    bool has_work() const;

    const std::function<bool()> may_share_;
    ThreadBenefit benefit_;
    bool shared_ = false; // Others take part in what is under way,
    ThreadBenefit::Clock::time_point started_at_;
    ThreadBenefit::Duration time_at_start_ = {}; // the caller's processor time when that began,
    long sleeps_at_start_ = 0;                   // and how often it had slept
    std::atomic<std::int64_t> helped_ = 0; // nanoseconds of the others' on jobs, not reckoned yet

    std::vector<std::thread> workers_;
    Job job_; // the same until all that have begun have ended
    std::atomic<Tickets> tickets_ = Tickets();
    static_assert(std::atomic<Tickets>::is_always_lock_free);
    std::atomic<std::size_t> left_ = 0; // jobs that have not ended
    std::atomic<bool> stopping_ = false;

    std::mutex mutex_; // for those who sleep, and over failure_
    std::condition_variable started_, done_;
    std::exception_ptr failure_;
};

} // namespace ffgpu
