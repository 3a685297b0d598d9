// DrawGatherer: the draws of the functional GPU's bins, each with all its batches: draws that the
// host split between bins are joined, and uploads come in their place between draws.
//
// It holds one bin, and of a draw that is not complete the bins so far.

#pragma once

#include "model/packets/work_stream.h"

#include <memory>
#include <vector>

namespace ffgpu::work {

// The batches of one draw, tile after tile of each bin, and the bins, which keep them alive.
struct DrawParts {
    std::vector<std::shared_ptr<const WorkBin>> bins;
    std::vector<const WorkBatch*> batches;
};

// In the order of the commands, from one thread.
class DrawSink {
public:
    virtual ~DrawSink() = default;
    virtual void draw(const WorkDraw& draw, const DrawParts& parts) = 0;
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
    DrawSink& out_;
    DrawParts begun_; // of the draw that goes on
};

} // namespace ffgpu::work
