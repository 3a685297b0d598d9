// SinkThread: takes the work stream off the thread that draws. What is handed over waits in a
// bounded queue and is read by one thread of its own, in order: the reader's results are the same
// as if it had been called directly.
//
// What the reader throws comes out of drain() or check_failure(); what is handed over after it is
// dropped.

#pragma once

#include "model/packets/work_stream.h"
#include "model/work/job_thread.h"

#include <cstdint>
#include <functional>
#include <memory>

namespace ffgpu::work {

class SinkThread final : public WorkSink {
public:
    explicit SinkThread(WorkSink& reader);

    void bin(std::shared_ptr<const WorkBin> bin) override;
    void end_frame(std::uint32_t frame) override;
    // Runs `job` on the reader's thread, after all that was handed over before.
    void post(std::function<void()> job);

    // Returns when all is read.
    void drain() { jobs_.drain(); }
    // Throws what the reader threw, once.
    void check_failure() { jobs_.check_failure(); }

private:
    WorkSink& reader_;
    JobThread jobs_;
};

} // namespace ffgpu::work
