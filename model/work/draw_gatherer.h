// DrawGatherer: the draws of the functional GPU's bins, each with all its batches: draws that the
// host split between bins are joined, and uploads come in their place between draws.
//
// It holds one bin, and of a draw that is not complete the bins so far.

#pragma once

#include "model/packets/work_stream.h"

#include <memory>
#include <span>
#include <vector>

namespace ffgpu::work {

// In the order of the commands, from one thread.
class DrawSink {
public:
    virtual ~DrawSink() = default;
    // The batches are tile after tile, of each bin.
    virtual void draw(const WorkDraw& draw, std::span<const WorkBatch* const> batches) = 0;
    virtual void content(const std::shared_ptr<const SurfaceContent>& content) = 0;
    virtual void host_transfer(const HostTransfer& transfer) = 0;
    virtual void end_frame(std::uint32_t frame) = 0;
};

class DrawGatherer final : public WorkSink {
public:
    explicit DrawGatherer(DrawSink& out)
        : out_(out) {}

    void bin(std::shared_ptr<const WorkBin> bin) override;
    void end_frame(std::uint32_t frame) override { out_.end_frame(frame); }

private:
    // The batches of one draw, a bin's after the other; they keep their bins alive.
    struct Parts {
        std::vector<std::shared_ptr<const WorkBin>> bins;
        std::vector<const WorkBatch*> batches;
    };

    DrawSink& out_;
    Parts begun_; // of the draw that goes on
};

} // namespace ffgpu::work
