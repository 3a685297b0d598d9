// CommandAssembler: makes whole commands of the functional GPU's bins (draw_splitter.h): parts of
// one draw are joined. Quads that the host drew tile by tile are brought into the canonical order.
//
// It holds one bin, and of a draw that is not complete the bins so far.

#pragma once

#include "model/work/canonical_order.h"
#include "model/work/draw_splitter.h"
#include "model/work/whole_command.h"

#include <memory>
#include <vector>

namespace ffgpu::work {

class CommandAssembler final : public WorkSink, private DrawSink {
public:
    explicit CommandAssembler(CommandSink& out)
        : out_(out)
        , splitter_(*this) {}

    void bin(std::shared_ptr<const WorkBin> bin) override { splitter_.bin(std::move(bin)); }
    void end_frame(std::uint32_t frame) override { out_.end_frame(frame); }

private:
    void draw_part(const WorkDraw& draw, const DrawPart& part) override;
    void content(const std::shared_ptr<const SurfaceContent>& content) override {
        out_.content(content);
    }
    void host_transfer(const HostTransfer& transfer) override { out_.host_transfer(transfer); }

    CommandSink& out_;
    CanonicalOrder order_;
    DrawSplitter splitter_;
    // Of the draw that goes on:
    std::vector<std::shared_ptr<const WorkBin>> bins_;
    std::vector<const WorkBatch*> batches_;
};

} // namespace ffgpu::work
