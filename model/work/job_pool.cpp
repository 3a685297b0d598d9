#include "model/work/job_pool.h"

#include "model/base/thread_without_signals.h"

#include <algorithm>
#include <utility>

namespace ffgpu::work {

JobPool::JobPool(unsigned threads) {
    for (unsigned i = 0; i < threads; ++i)
        threads_.push_back(thread_without_signals([this] { work(); }));
}

JobPool::~JobPool() {
    {
        const std::lock_guard lock(mutex_);
        stopping_ = true;
    }
    changed_.notify_all();
    for (std::thread& thread : threads_)
        thread.join();
}

void JobPool::work() {
    std::unique_lock lock(mutex_);
    while (!stopping_)
        if (!run_one(lock, 0)) changed_.wait(lock);
}

bool JobPool::run_one(std::unique_lock<std::mutex>& lock, unsigned first_stage) {
    for (Order* const order : orders_) {
        if (order->stage_ < first_stage) return false;
        if (!order->jobs_.is_ready()) continue;
        order->jobs_.run_first(lock, changed_);
        return true;
    }
    return false;
}

bool JobPool::has_jobs() const {
    const std::lock_guard lock(mutex_);
    return std::any_of(
        orders_.begin(), orders_.end(), [](const Order* order) { return !order->jobs_.is_done(); });
}

JobPool::Order::Order(JobPool& pool, unsigned stage, std::size_t most_weight)
    : pool_(pool)
    , stage_(stage)
    , jobs_(most_weight) {
    const std::lock_guard lock(pool_.mutex_);
    const auto later = [stage](const Order* other) { return other->stage_ > stage; };
    auto& orders = pool_.orders_;
    orders.insert(std::find_if_not(orders.begin(), orders.end(), later), this);
}

JobPool::Order::~Order() {
    std::unique_lock lock(pool_.mutex_);
    wait_until_done(lock);
    std::erase(pool_.orders_, this);
}

void JobPool::Order::push(std::size_t weight, std::function<void()> run) {
    std::unique_lock lock(pool_.mutex_);
    while (!jobs_.takes(weight))
        if (!pool_.run_one(lock, stage_)) pool_.changed_.wait(lock);
    jobs_.add(weight, std::move(run));
    pool_.changed_.notify_all();
}

void JobPool::Order::wait_until_done(std::unique_lock<std::mutex>& lock) {
    while (!jobs_.is_done())
        if (!pool_.run_one(lock, stage_)) pool_.changed_.wait(lock);
}

void JobPool::Order::drain() {
    std::unique_lock lock(pool_.mutex_);
    wait_until_done(lock);
    jobs_.rethrow(lock);
}

void JobPool::Order::check_failure() {
    std::unique_lock lock(pool_.mutex_);
    jobs_.rethrow(lock);
}

} // namespace ffgpu::work
