#include "model/work/job_list.h"

#include <utility>

namespace ffgpu::work {

void JobList::add(std::size_t weight, std::function<void()> run) {
    if (failed_) return;
    weight_ += weight;
    jobs_.push_back({weight, std::move(run)});
}

void JobList::run_first(std::unique_lock<std::mutex>& lock, std::condition_variable& changed) {
    Job job = std::move(jobs_.front());
    jobs_.pop_front();
    weight_ -= job.weight;
    busy_ = true;
    changed.notify_all();
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
    changed.notify_all();
}

void JobList::rethrow(std::unique_lock<std::mutex>& lock) {
    if (!failure_) return;
    const std::exception_ptr failure = std::exchange(failure_, nullptr);
    lock.unlock();
    std::rethrow_exception(failure);
}

} // namespace ffgpu::work
