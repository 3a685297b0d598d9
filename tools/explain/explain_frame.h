// explain_frame: carries a frame out once more, by the scalar specifications, and tells what
// happened to pixels of its picture.

#pragma once

#include "model/timing/config.h"
#include "tools/explain/pixel_history.h"

#include <utility>
#include <vector>

namespace ffgpu::tools {

struct FrameQuestion {
    const FrameTape& tape;
    Surface picture;
    std::vector<std::pair<unsigned, unsigned>> pixels; // of the picture, from the upper left
    std::vector<std::uint32_t> values;                 // theirs, as the frame left them: rgba8
    const timing::TimingConfig* timing = nullptr;      // null: no word of the machine in time
    WorkSink* work = nullptr;                          // is told of the frame's work, or null
};

// A history for each pixel. Checks that its events lead without a gap from what the pixel was
// before the frame to the value that the frame left.
std::vector<PixelHistory> explain_frame(const FrameQuestion& question);

} // namespace ffgpu::tools
