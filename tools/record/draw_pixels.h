// DrawPixels: draw_pixels.csv, a line a draw: which pixels of the frame that is shown it covered,
// and which of them it wrote. docs/stats.md tells of its columns.

#pragma once

#include "model/base/whole_file.h"
#include "model/device/registers/fragment.h"
#include "model/work/whole_command.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace ffgpu::tools {

class DrawPixels final : public work::CommandSink {
public:
    // Throws InputError where the file cannot be written, as frame() and finish().
    explicit DrawPixels(const std::string& path);

    // CommandSink
    void command(std::shared_ptr<const work::WholeCommand> command) override;
    void host_transfer(const HostTransfer&) override {}
    void end_frame(std::uint32_t) override {}

    // The frame's commands are all here; what was drawn into another surface is not told.
    void frame(std::uint64_t number, const Surface& shown);
    void finish() { file_.commit(); }

private:
    struct Row {
        Surface surface;
        std::string text; // all columns but the frame
    };

    WholeFile file_;
    std::vector<Row> rows_; // of the frame under way
};

// A pixel of the box of a draw.
enum class DrawnPixel : char { None = 'n', Killed = 'k', Written = 'w' };

// "n3w12k1": letters with how often, row by row.
std::string pixel_runs(const std::vector<DrawnPixel>& pixels);

} // namespace ffgpu::tools
