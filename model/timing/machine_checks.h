// Whether a machine can be built: what parameters ask of each other, each in its range.

#pragma once

#include "model/timing/config.h"

namespace ffgpu::timing {

// Throws InputError that names the parameters.
void check_machine(const TimingConfig& config);

} // namespace ffgpu::timing
