// Explain: a frame of a trace or capture, drawn as `replay` draws it and kept, so that its pixels
// can be asked for.

#pragma once

#include "driver/framebuffer/drawable.h"
#include "tools/config/configuration.h"
#include "tools/explain/pixel_history.h"

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace ffgpu::tools {

struct ExplainOptions {
    std::string input;
    std::uint64_t frame = 0;
    unsigned samples = 1; // of a pixel of a trace's windows
    gl::SwapMode swap = gl::SwapMode::Copy;
    bool timing = false; // with the machine in time
    Configuration configuration{};
    std::function<void(const std::string& line)> warn = [](const std::string&) {};
};

using PicturePixel = std::pair<unsigned, unsigned>; // x and y from the upper left

class ExplainedFrame {
public:
    // Throws InputError where there is no such frame, or no picture of it.
    explicit ExplainedFrame(const ExplainOptions& options);

    unsigned width() const { return picture_.width; }
    unsigned height() const { return picture_.height; }
    const FrameTape& tape() const { return device_->tape(); }

    // In the pixels' order. `work` is told of the frame's work, or null. Throws InputError for a
    // pixel outside the picture.
    std::vector<PixelHistory> histories(const std::vector<PicturePixel>& pixels,
                                        WorkSink* work = nullptr) const;

private:
    Surface play();
    std::vector<std::uint32_t> values(const std::vector<PicturePixel>& pixels) const;

    const ExplainOptions options_;
    std::unique_ptr<FunctionalGpu> gpu_;
    std::unique_ptr<TapeDevice> device_;
    bool from_trace_ = false;
    Surface picture_;
};

} // namespace ffgpu::tools
