// Which fragments a stipple pattern keeps from being made.

#pragma once

#include "model/device/registers.h"
#include "model/raster/setup_record.h"

namespace ffgpu::tools {

// Whether the primitive covers the window pixel, or a sample of it, and its stipple takes it out.
bool is_stippled_out(const SetupRecord& record, const Registers& registers, int x, int y);

} // namespace ffgpu::tools
