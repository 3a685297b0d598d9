// DrawSplitter: the functional GPU's bins draw by draw, in the order of the commands; uploads come
// in their place between draws. Of a draw that the host split between bins each has a part.

#pragma once

#include "model/packets/work_stream.h"

#include <memory>
#include <vector>

namespace ffgpu::work {

// A bin's batches of one draw, tile after tile, which the bin keeps alive.
struct DrawPart {
    std::shared_ptr<const WorkBin> bin;
    std::vector<const WorkBatch*> batches;
    bool last = true; // The next bin does not go on with the draw.
};

// In the order of the commands, one after another.
class DrawSink {
public:
    virtual ~DrawSink() = default;
    virtual void draw_part(const WorkDraw& draw, const DrawPart& part) = 0;
    virtual void content(const std::shared_ptr<const SurfaceContent>& content) = 0;
    virtual void host_transfer(const HostTransfer& transfer) = 0;
    virtual void end_frame(std::uint32_t frame) = 0;
};

class DrawSplitter final : public WorkSink {
public:
    explicit DrawSplitter(DrawSink& out)
        : out_(out) {}

    void bin(std::shared_ptr<const WorkBin> bin) override;
    void end_frame(std::uint32_t frame) override { out_.end_frame(frame); }

private:
    DrawSink& out_;
    bool goes_on_ = false; // the last draw of the bin before
};

} // namespace ffgpu::work
