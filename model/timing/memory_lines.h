// Whether what is configured fits the memory. A cache's line is one request, and lies in one row of
// one channel; between two refreshes a row must be opened, used and closed.

#pragma once

#include "model/timing/config.h"

namespace ffgpu::timing {

// Throws InputError that names both parameters.
void check_memory_lines(const TimingConfig& config);

// Throws InputError that names the parameter and what is enough.
void check_refresh(const TimingConfig& config);

} // namespace ffgpu::timing
