// SinkThread: takes the work stream off the thread that draws. What is handed over waits in a
// bounded queue and is read by one thread of its own, in order: the reader's results are the same
// as if it had been called directly.
//
// What the reader throws comes out of drain() or check_failure(); what is handed over after it is
// dropped.

#pragma once

#include "model/packets/work_stream.h"

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

namespace ffgpu::work {

class SinkThread final : public WorkSink {
public:
    explicit SinkThread(WorkSink& reader);
    ~SinkThread() override; // Waits for the reader, and drops what it throws.
    SinkThread(const SinkThread&) = delete;
    SinkThread& operator=(const SinkThread&) = delete;

    void bin(std::shared_ptr<const WorkBin> bin) override;
    void end_frame(std::uint32_t frame) override;
    // Runs `job` on the reader's thread, after all that was handed over before.
    void post(std::function<void()> job);

    // Returns when all is read.
    void drain();
    // Throws what the reader threw, once.
    void check_failure();

private:
    struct Job {
        std::size_t weight = 1; // quads, about
        std::function<void()> run;
    };

    void push(Job job);
    void work();
    void rethrow(std::unique_lock<std::mutex>& lock);

    WorkSink& reader_;
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
