#include "model/work/sink_thread.h"

#include <csignal>
#include <utility>

namespace ffgpu::work {
namespace {

constexpr std::size_t MostWeight = 1 << 18; // quads that wait: some tens of megabytes

std::size_t weight_of(const WorkBin& bin) {
    std::size_t quads = 1 + bin.draws.size() + bin.transfers.size();
    for (const WorkTile& tile : bin.tiles)
        for (const WorkBatch& batch : tile.batches)
            quads += batch.quads.size();
    return quads;
}

// Signals are the drawing thread's: a program's handlers do not run on a thread that it does not
// know.
std::thread without_signals(std::function<void()> run) {
    sigset_t all, before;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    std::thread thread(std::move(run));
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
    return thread;
}

} // namespace

SinkThread::SinkThread(WorkSink& reader)
    : reader_(reader)
    , thread_(without_signals([this] { work(); })) {}

SinkThread::~SinkThread() {
    {
        const std::lock_guard lock(mutex_);
        stopping_ = true;
    }
    changed_.notify_all();
    thread_.join();
}

void SinkThread::bin(std::shared_ptr<const WorkBin> bin) {
    const std::size_t weight = weight_of(*bin);
    push({weight, [this, bin = std::move(bin)]() mutable { reader_.bin(std::move(bin)); }});
}

void SinkThread::end_frame(std::uint32_t frame) {
    push({1, [this, frame] { reader_.end_frame(frame); }});
}

void SinkThread::post(std::function<void()> job) {
    push({1, std::move(job)});
}

// One job fits always, however heavy it is.
void SinkThread::push(Job job) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] {
        return failed_ || jobs_.empty() || weight_ + job.weight <= MostWeight;
    });
    if (failed_) return;
    weight_ += job.weight;
    jobs_.push_back(std::move(job));
    changed_.notify_all();
}

void SinkThread::drain() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return jobs_.empty() && !busy_; });
    rethrow(lock);
}

void SinkThread::check_failure() {
    std::unique_lock lock(mutex_);
    rethrow(lock);
}

void SinkThread::rethrow(std::unique_lock<std::mutex>& lock) {
    if (!failure_) return;
    const std::exception_ptr failure = std::exchange(failure_, nullptr);
    lock.unlock();
    std::rethrow_exception(failure);
}

void SinkThread::work() {
    std::unique_lock lock(mutex_);
    while (true) {
        changed_.wait(lock, [this] { return stopping_ || !jobs_.empty(); });
        if (jobs_.empty()) return;
        Job job = std::move(jobs_.front());
        jobs_.pop_front();
        weight_ -= job.weight;
        busy_ = true;
        changed_.notify_all();
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
        changed_.notify_all();
    }
}

} // namespace ffgpu::work
