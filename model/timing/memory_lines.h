// Whether the caches' lines fit the memory: a line is one request, and lies in one row of one
// channel.

#pragma once

#include "model/timing/config.h"

namespace ffgpu::timing {

// Throws InputError that names both parameters.
void check_memory_lines(const TimingConfig& config);

} // namespace ffgpu::timing
