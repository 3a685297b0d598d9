// SinkThread: takes the work stream off the thread that draws. What is handed over waits in a
// bounded queue and is read in order, by one thread of its own or as the first stage of a pool's:
// the reader's results are the same as if it had been called directly.
//
// What the reader throws comes out of drain() or check_failure(); what is handed over after it is
// dropped.

#pragma once

#include "model/packets/work_stream.h"
#include "model/work/job_order.h"
#include "model/work/job_pool.h"

#include <cstdint>
#include <functional>
#include <memory>

namespace ffgpu::work {

class SinkThread final : public WorkSink {
public:
    // `pool`: null, if it has a thread of its own.
    explicit SinkThread(WorkSink& reader, JobPool* pool = nullptr);

    void bin(std::shared_ptr<const WorkBin> bin) override;
    void end_frame(std::uint32_t frame) override;
    // Runs `job` as the reader is called, after all that was handed over before.
    void post(std::function<void()> job);

    // Returns when all is read.
    void drain() { jobs_->drain(); }
    // Throws what the reader threw, once.
    void check_failure() { jobs_->check_failure(); }

private:
    WorkSink& reader_;
    std::unique_ptr<JobOrder> jobs_;
};

} // namespace ffgpu::work
