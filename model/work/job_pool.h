// JobPool: several orders of jobs on few threads, so that there are no more of these than
// processors. Whoever waits, for room or for the end, does jobs in the meantime.
//
// Each order has a stage, and its jobs hand on to orders of later stages only. Who waits does jobs
// of that stage and later ones: what a thread is in the middle of is of earlier stages, so that
// nobody waits for himself. The latest stage comes first: it makes room for the others.

#pragma once

#include "model/work/job_list.h"
#include "model/work/job_order.h"

#include <condition_variable>
#include <mutex>
#include <thread>
#include <vector>

namespace ffgpu::work {

class JobPool {
public:
    // Besides those that wait; none is enough.
    explicit JobPool(unsigned threads);
    ~JobPool(); // Its orders are gone.
    JobPool(const JobPool&) = delete;
    JobPool& operator=(const JobPool&) = delete;

    unsigned threads() const { return static_cast<unsigned>(threads_.size()); }
    // Whether a job waits, or is under way.
    bool has_jobs() const;

    class Order final : public JobOrder {
    public:
        Order(JobPool& pool, unsigned stage, std::size_t most_weight);
        ~Order() override; // Waits for the jobs, and drops what they throw.
        Order(const Order&) = delete;
        Order& operator=(const Order&) = delete;

        void push(std::size_t weight, std::function<void()> run) override;
        void drain() override;
        void check_failure() override;

    private:
        friend class JobPool;

        void wait_until_done(std::unique_lock<std::mutex>& lock);

        JobPool& pool_;
        const unsigned stage_;
        JobList jobs_;
    };

private:
    void work();
    // Does a job of one of these stages, if one is ready.
    bool run_one(std::unique_lock<std::mutex>& lock, unsigned first_stage);

    mutable std::mutex mutex_;
    std::condition_variable changed_;
    std::vector<Order*> orders_; // the latest stage first
    bool stopping_ = false;
    std::vector<std::thread> threads_;
};

} // namespace ffgpu::work
