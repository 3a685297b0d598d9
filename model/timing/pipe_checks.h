// What the parameters of the fragment pipe ask of each other.

#pragma once

#include "model/timing/config.h"

namespace ffgpu::timing {

// Throws InputError.
void check_pipe(const TimingConfig& config);

} // namespace ffgpu::timing
