// CommandAssembler: makes whole commands of the functional GPU's bins (draw_gatherer.h). Quads that
// the host drew tile by tile are brought into the canonical order.

#pragma once

#include "model/work/canonical_order.h"
#include "model/work/draw_gatherer.h"
#include "model/work/whole_command.h"

#include <memory>

namespace ffgpu::work {

class CommandAssembler final : public WorkSink, private DrawSink {
public:
    explicit CommandAssembler(CommandSink& out)
        : out_(out)
        , gatherer_(*this) {}

    void bin(std::shared_ptr<const WorkBin> bin) override { gatherer_.bin(std::move(bin)); }
    void end_frame(std::uint32_t frame) override { out_.end_frame(frame); }

private:
    void draw(const WorkDraw& draw, const DrawParts& parts) override;
    void content(const std::shared_ptr<const SurfaceContent>& content) override {
        out_.content(content);
    }
    void host_transfer(const HostTransfer& transfer) override { out_.host_transfer(transfer); }

    CommandSink& out_;
    CanonicalOrder order_;
    DrawGatherer gatherer_;
};

} // namespace ffgpu::work
