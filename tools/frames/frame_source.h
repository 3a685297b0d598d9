// FrameSource: what is replayed, a trace or a device capture, frame by frame.

#pragma once

#include "driver/framebuffer/drawable.h"
#include "driver/objects/control_panel.h"
#include "model/device/device.h"
#include "tools/frames/frame.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace ffgpu::tools {

class FrameSource {
public:
    virtual ~FrameSource() = default;

    // The number of the frame that next() plays first.
    virtual std::uint64_t first_frame() const { return 0; }

    // Plays what comes before the first frame and is none of its work: a capture's snapshot.
    // Returns the number of the first draw. Throws InputError.
    virtual std::uint32_t prepare() { return 0; }

    // Plays up to the end of the next frame; nothing at the end. Throws InputError.
    virtual std::optional<Frame> next() = 0;

    // Of a trace: there are calls.
    virtual bool has_calls() const { return false; }

    // Plays the last frame's calls again, as often as wanted; false where that cannot be done.
    virtual bool repeat_last() { return false; }
};

struct FrameSourceOptions {
    std::function<void(const std::string& line)> warn;
    bool report_errors = false; // GL errors, as warnings
    bool keep_last = false;     // repeat_last() will be called.
    unsigned samples = 1;       // of a pixel of a trace's windows
    gl::SwapMode swap = gl::SwapMode::Copy;
    gl::ControlPanel panel{}; // of the driver that a trace is played on
    // Before each call of a trace is played.
    std::function<void(std::uint64_t number, std::string_view name)> on_call{};
};

// Throws InputError where windows cannot be so.
void check_samples(unsigned samples, const gl::ControlPanel& panel);

// Tells by its first bytes what the file is. Throws InputError.
std::unique_ptr<FrameSource>
open_frame_source(const std::string& path, Device& device, const FrameSourceOptions& options);

} // namespace ffgpu::tools
