// Frame: what a swap of buffers handed over.

#pragma once

#include "model/device/layout/formats.h"

#include <cstdint>

namespace ffgpu::tools {

struct Frame {
    std::uint64_t number = 0;
    Surface picture;             // Format None: there is none.
    std::uint64_t api_calls = 0; // of the frame; 0 in a capture
};

} // namespace ffgpu::tools
