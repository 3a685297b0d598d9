// CommandAssembler: makes whole commands of the functional GPU's bins. Quads that the host drew
// tile by tile are brought into the canonical order, draws that it split between bins are joined,
// and uploads come in their place between draws.
//
// It holds one bin, and of a draw that is not complete the bins so far.

#pragma once

#include "model/work/whole_command.h"

#include <memory>
#include <vector>

namespace ffgpu::work {

class CommandAssembler final : public WorkSink {
public:
    explicit CommandAssembler(CommandSink& out)
        : out_(out) {}

    void bin(std::shared_ptr<const WorkBin> bin) override;
    void end_frame(std::uint32_t frame) override { out_.end_frame(frame); }

private:
    // The batches of one draw, a bin's after the other; they keep their bins alive.
    struct Parts {
        std::vector<std::shared_ptr<const WorkBin>> bins;
        std::vector<const WorkBatch*> batches;
    };

    static std::shared_ptr<const WholeCommand> assemble(const WorkDraw& draw, const Parts& parts);

    CommandSink& out_;
    Parts begun_; // of the draw that goes on
};

} // namespace ffgpu::work
