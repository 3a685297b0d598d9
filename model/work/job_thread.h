// JobThread: a thread of its own for the jobs of one order.

#pragma once

#include "model/work/job_list.h"
#include "model/work/job_order.h"

#include <condition_variable>
#include <mutex>
#include <thread>

namespace ffgpu::work {

class JobThread final : public JobOrder {
public:
    explicit JobThread(std::size_t most_weight);
    ~JobThread() override; // Waits for the jobs, and drops what they throw.
    JobThread(const JobThread&) = delete;
    JobThread& operator=(const JobThread&) = delete;

    void push(std::size_t weight, std::function<void()> run) override;
    void drain() override;
    void check_failure() override;

    // Some wait, beside the one under way.
    bool has_more() const {
        const std::lock_guard lock(mutex_);
        return jobs_.has_more();
    }

private:
    void work();

    mutable std::mutex mutex_;
    std::condition_variable changed_;
    JobList jobs_;
    bool stopping_ = false;
    std::thread thread_; // The last: it uses the others.
};

} // namespace ffgpu::work
