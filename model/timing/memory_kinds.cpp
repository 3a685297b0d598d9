#include "model/timing/memory_kinds.h"

#include "model/timing/fixed_memory.h"
#include "model/timing/memory_controller.h"

namespace ffgpu::timing {

std::unique_ptr<MemoryModule> configured_memory(const Clock& clock, const MemoryConfig& config) {
    if (config.kind == MemoryKind::Fixed)
        return std::make_unique<FixedMemory>("memory", clock, config);
    return std::make_unique<MemoryController>("memory", clock, config);
}

} // namespace ffgpu::timing
