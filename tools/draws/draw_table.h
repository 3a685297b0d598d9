// DrawTable: draws.csv, a line a command that touches pixels: which call of the trace it came from,
// what was drawn, what became of its fragments, what it read, and what it cost.

#pragma once

#include "model/base/whole_file.h"
#include "model/timing/gpu_timing.h"
#include "model/timing/quad_observer.h"
#include "model/work/whole_command.h"
#include "tools/draws/draw_notes.h"

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace ffgpu::tools {

class DrawTable final : public work::CommandSink, public timing::QuadObserver {
public:
    // Throws InputError where the file cannot be written, as write() and finish().
    DrawTable(const std::string& path, DrawNotes& notes);

    // CommandSink
    void command(std::shared_ptr<const work::WholeCommand> command) override;
    void host_transfer(const HostTransfer&) override {}
    void end_frame(std::uint32_t) override {}

    // QuadObserver, on the machine's thread
    void texel_line(const timing::QuadName& name, const timing::CacheLine& line) override;

    // The frame's commands are all here. `timed`: what the machine took; null: there is none.
    void write(std::uint64_t frame, const timing::FrameTiming* timed);
    void finish() { file_.commit(); }

private:
    struct Row {
        timing::CommandKind kind = timing::CommandKind::Draw;
        std::uint32_t number = 0;
        std::string facts; // all columns but those before and those of time
    };

    std::uint64_t misses_of(const Row& row);

    WholeFile file_;
    DrawNotes& notes_;
    std::vector<Row> rows_; // of the frame under way
    std::mutex mutex_;
    std::map<std::uint32_t, std::uint64_t> misses_; // of texel lines, by draw
};

} // namespace ffgpu::tools
