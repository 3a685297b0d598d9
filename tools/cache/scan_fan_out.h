// ScanFanOut: hands what was drawn to several scans of its texels.

#pragma once

#include "model/work/texel_scan.h"
#include "tools/work/work_player.h"

#include <memory>
#include <vector>

namespace ffgpu::tools {

class ScanFanOut final : public DrawReader {
public:
    void add(work::TexelScan& scan) { scans_.push_back(&scan); }

    void draw_part(const WorkDraw& draw, const work::DrawPart& part) override {
        for (work::TexelScan* const scan : scans_)
            scan->draw_part(draw, part);
    }
    void command(std::shared_ptr<const work::WholeCommand> command) override {
        for (work::TexelScan* const scan : scans_)
            scan->command(command);
    }
    void content(const std::shared_ptr<const SurfaceContent>& content) override {
        for (work::TexelScan* const scan : scans_)
            scan->content(content);
    }
    void host_transfer(const HostTransfer& transfer) override {
        for (work::TexelScan* const scan : scans_)
            scan->host_transfer(transfer);
    }
    void end_frame(std::uint32_t frame) override {
        for (work::TexelScan* const scan : scans_)
            scan->end_frame(frame);
    }

private:
    std::vector<work::TexelScan*> scans_;
};

} // namespace ffgpu::tools
