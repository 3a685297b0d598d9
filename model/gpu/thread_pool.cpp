#include "model/gpu/thread_pool.h"

#include "model/base/check.h"
#include "model/base/float_environment.h"
#include "model/base/thread_without_signals.h"

#include <ctime>
#include <limits>
#include <utility>

#include <sys/resource.h>

namespace ffgpu {
namespace {

void pause() {
#if defined(__x86_64__)
    __builtin_ia32_pause();
#endif
}

// What others do soon is waited for awake: to sleep and to be woken takes tens of microseconds, and
// as long of the thread that wakes. So long is a caller with its own affairs between two lists of
// jobs. Nothing is yielded: a scheduler may take it for a whole slice that was used.
template <class Ready>
bool comes_soon(Ready&& ready) {
    constexpr std::chrono::microseconds Soon(100);
    constexpr int LooksAtOnce = 16; // A look at the clock takes as long as one or two.
    const auto end = ThreadBenefit::Clock::now() + Soon;
    do {
        for (int i = 0; i < LooksAtOnce; ++i) {
            if (ready()) return true;
            pause();
        }
    } while (ThreadBenefit::Clock::now() < end);
    return ready();
}

// For which this thread had a processor.
ThreadBenefit::Duration processor_time() {
    timespec time = {};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

// How often this thread went to sleep by itself.
long own_sleeps() {
    rusage usage = {};
    getrusage(RUSAGE_THREAD, &usage);
    return usage.ru_nvcsw;
}

} // namespace

ThreadPool::ThreadPool(unsigned threads, std::function<bool()> may_share)
    : may_share_(std::move(may_share)) {
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

void ThreadPool::start(std::size_t count, Job job) {
    check(left_ == 0, "a list of jobs is under way");
    check(count <= std::numeric_limits<std::uint32_t>::max(), "so many jobs at once");
    job_ = std::move(job);
    left_ = count;
    if (!shares()) return run_alone(count);
    shared_ = true;
    started_at_ = ThreadBenefit::Clock::now();
    time_at_start_ = processor_time();
    sleeps_at_start_ = own_sleeps();
    {
        const std::lock_guard lock(mutex_);
        tickets_ = {0, static_cast<std::uint32_t>(count)};
    }
    started_.notify_all();
}

void ThreadPool::wait() {
    if (shared_) {
        take_jobs(0);
        wait_for_others();
        shared_ = false;
    }
    const std::lock_guard lock(mutex_);
    if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
}

void ThreadPool::wait_for_others() {
    const auto is_done = [this] { return done(); };
    const ThreadBenefit::Clock::time_point begin = ThreadBenefit::Clock::now();
    ThreadBenefit::Duration kept_off = begin - started_at_ - (processor_time() - time_at_start_);
    if (own_sleeps() != sleeps_at_start_) kept_off = {}; // It had nothing to do.
    if (!comes_soon(is_done)) {
        std::unique_lock lock(mutex_);
        done_.wait(lock, is_done);
    }
    const ThreadBenefit::Clock::time_point end = ThreadBenefit::Clock::now();
    benefit_.add(ThreadBenefit::Duration(helped_.exchange(0)), kept_off + (end - begin), end);
}

void ThreadPool::run(std::size_t count, Job job) {
    start(count, std::move(job));
    wait();
}

// Nobody else sees these jobs.
void ThreadPool::run_alone(std::size_t count) {
    try {
        for (std::size_t index = 0; index < count; ++index)
            job_(0, index);
    } catch (...) {
        failure_ = std::current_exception();
    }
    left_ = 0;
}

bool ThreadPool::has_work() const {
    const Tickets tickets = tickets_;
    return tickets.next < tickets.count;
}

// Whoever takes an index holds the list: it is not replaced before that job has ended.
bool ThreadPool::take(std::size_t& index) {
    Tickets tickets = tickets_;
    while (tickets.next < tickets.count) {
        index = tickets.next;
        if (tickets_.compare_exchange_weak(tickets, {tickets.next + 1, tickets.count})) return true;
    }
    return false;
}

void ThreadPool::take_jobs(unsigned worker) {
    for (std::size_t index = 0; take(index); end_jobs(1)) {
        try {
            job_(worker, index);
        } catch (...) {
            keep_failure(std::current_exception());
        }
    }
}

// The first is told; jobs that have not begun are left out.
void ThreadPool::keep_failure(std::exception_ptr failure) {
    {
        const std::lock_guard lock(mutex_);
        if (!failure_) failure_ = std::move(failure);
    }
    const Tickets not_begun = tickets_.exchange({});
    end_jobs(not_begun.count - not_begun.next);
}

void ThreadPool::end_jobs(std::size_t ended) {
    if (ended == 0 || left_.fetch_sub(ended) != ended) return;
    const std::lock_guard lock(mutex_);
    done_.notify_one();
}

void ThreadPool::work(unsigned worker) {
    const FloatEnvironment environment; // A thread begins with the mode of the one that made it.
    const auto ready = [this] { return stopping_ || has_work(); };
    while (true) {
        if (!comes_soon(ready)) {
            std::unique_lock lock(mutex_);
            started_.wait(lock, ready);
        }
        if (stopping_) return;
        const ThreadBenefit::Duration begin = processor_time();
        take_jobs(worker);
        helped_ += (processor_time() - begin).count();
    }
}

} // namespace ffgpu
