// The memories of ours, by configuration.

#pragma once

#include "model/timing/config.h"
#include "model/timing/memory_module.h"

#include <memory>

namespace ffgpu::timing {

std::unique_ptr<MemoryModule> configured_memory(const Clock& clock, const MemoryConfig& config);

} // namespace ffgpu::timing
