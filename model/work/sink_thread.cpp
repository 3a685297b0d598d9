#include "model/work/sink_thread.h"

#include "model/work/job_thread.h"

#include <utility>

namespace ffgpu::work {
namespace {

constexpr std::size_t MostWeight = 1 << 17; // quads that wait: some megabytes

std::size_t weight_of(const WorkBin& bin) {
    std::size_t quads = 1 + bin.draws.size() + bin.transfers.size();
    for (const WorkTile& tile : bin.tiles)
        for (const WorkBatch& batch : tile.batches)
            quads += batch.quads.size();
    return quads;
}

std::unique_ptr<JobOrder> first_stage(JobPool* pool) {
    if (pool) return std::make_unique<JobPool::Order>(*pool, 0, MostWeight);
    return std::make_unique<JobThread>(MostWeight);
}

} // namespace

SinkThread::SinkThread(WorkSink& reader, JobPool* pool)
    : reader_(reader)
    , jobs_(first_stage(pool)) {}

void SinkThread::bin(std::shared_ptr<const WorkBin> bin) {
    const std::size_t weight = weight_of(*bin);
    jobs_->push(weight, [this, bin = std::move(bin)]() mutable { reader_.bin(std::move(bin)); });
}

void SinkThread::end_frame(std::uint32_t frame) {
    jobs_->push(1, [this, frame] { reader_.end_frame(frame); });
}

void SinkThread::post(std::function<void()> job) {
    jobs_->push(1, std::move(job));
}

} // namespace ffgpu::work
