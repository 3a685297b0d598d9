// A range of frames, or of draws, as the command line gives it: "3-7", "3" or "3-".

#pragma once

#include <cstdint>
#include <limits>
#include <string>

namespace ffgpu::tools {

struct FrameRange {
    std::uint64_t first = 0;
    std::uint64_t last = std::numeric_limits<std::uint64_t>::max(); // included

    bool contains(std::uint64_t frame) const { return first <= frame && frame <= last; }
    bool operator==(const FrameRange&) const = default;
};

// Throws InputError.
FrameRange parse_frame_range(const std::string& text, const std::string& option = "--frames");

// The same for CLI11's each(), which is asked of a text that is empty, too: it is no range.
inline void check_frame_range(const std::string& text) {
    parse_frame_range(text);
}

// One line about frames that were asked for, of a source that ended behind `count` of them; empty:
// all are there.
std::string
missing_frames(const FrameRange& wanted, const std::string& source, std::uint64_t count);

} // namespace ffgpu::tools
