// The work of a trace, a device capture or a work file, played to whoever reads whole commands.

#pragma once

#include "model/packets/work_stream.h"
#include "model/work/draw_splitter.h"
#include "model/work/frame_figures.h"
#include "model/work/job_pool.h"
#include "model/work/whole_command.h"
#include "tools/config/configuration.h"
#include "tools/frames/frame_range.h"

#include <cstdint>
#include <functional>
#include <string>

namespace ffgpu::tools {

// A warning: settings of the driver come too late for a work file.
std::string forces_nothing(const std::string& path);

struct WorkPlayOptions {
    std::string input{};
    FrameRange frames{};                           // A work file is played whole.
    std::uint64_t ends_behind = FrameRange{}.last; // this frame, of any input
    GpuParameters gpu{};
    // Whose work it is: work with values where it needs them, which a file may lack.
    timing::TimingConfig machine{};
    std::function<void(const std::string& line)> warn = [](const std::string&) {};
    // What is drawn is handed over as its first stage; null: on a thread of its own.
    work::JobPool* pool = nullptr;
    // false: colours are drawn where they decide on fragments alone; throws MissedColors where that
    // was not enough, and all that was handed over is void.
    bool colors = true;
    std::uint64_t at_least = 0; // Frames before this one are played whatever Interruption comes.
};

struct MissedColors {
    std::uint64_t next = 0; // the frame behind those that were played
};

// Calls `frame` where a frame's work has all been handed over; that and all calls of the sink come
// one after another, from threads that need not be the caller's. Ends behind a frame where an
// Interruption came, perhaps without any. Throws InputError; all that came before the fault has
// been handed over then. Returns whether more work came behind the last frame that ended, which is
// in no frame's figures: WorkPlayOptions::ends_behind leaves it out.
bool play_work(const WorkPlayOptions& options,
               work::CommandSink& sink,
               const std::function<void(const work::FrameFigures&)>& frame);

// Reads draws as they were drawn, where the input is drawn; a work file has commands.
class DrawReader : public work::DrawSink, public work::CommandSink {};

bool play_work(const WorkPlayOptions& options,
               DrawReader& reader,
               const std::function<void(const work::FrameFigures&)>& frame);

} // namespace ffgpu::tools
