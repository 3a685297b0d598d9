// Whether what the caches are configured to be exists.

#pragma once

#include "model/timing/config.h"

namespace ffgpu::timing {

// Throws InputError that names the parameter.
void check_caches(const TimingConfig& config);

} // namespace ffgpu::timing
