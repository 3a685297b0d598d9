// Pictures out of device memory.

#pragma once

#include "model/device/device.h"
#include "tools/image/image.h"

namespace ffgpu::tools {

// The surface's colours, its top row first. Empty for Format None.
Image read_surface(Device& device, const Surface& surface);

} // namespace ffgpu::tools
