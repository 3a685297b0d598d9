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
#include <span>
#include <string>
#include <utility>
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

    struct Row {
        timing::CommandKind kind = timing::CommandKind::Draw;
        std::uint32_t number = 0;
        std::string facts; // all columns but those before and those of time
    };

    // Those of the frame's commands, which are all here.
    std::vector<Row> take_rows() { return std::exchange(rows_, {}); }
    // `timed`: what the machine took, on its thread; null: there is none.
    void write(std::uint64_t frame, std::span<const Row> rows, const timing::FrameTiming* timed);
    void finish() { file_.commit(); }

private:
    std::uint64_t misses_of(const Row& row) const;

    WholeFile file_;
    DrawNotes& notes_;
    std::vector<Row> rows_;                         // of the frame under way
    std::map<std::uint32_t, std::uint64_t> misses_; // of texel lines, by draw; the machine's
};

} // namespace ffgpu::tools
