#include "tools/rtl/wave_range.h"

#include "tools/frames/frame_range.h"

namespace ffgpu::tools {

rtl::WaveCycles parse_wave_cycles(const std::string& text) {
    if (text.empty()) return {};
    const FrameRange range = parse_frame_range(text, "--fst-cycles");
    if (range.last == FrameRange{}.last) return {.first = range.first};
    return {range.first, range.last};
}

} // namespace ffgpu::tools
