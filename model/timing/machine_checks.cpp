#include "model/timing/machine_checks.h"

#include "model/timing/cache_checks.h"
#include "model/timing/memory_lines.h"
#include "model/timing/pipe_checks.h"
#include "model/timing/target_blocks.h"

namespace ffgpu::timing {

void check_machine(const TimingConfig& config) {
    check_memory_lines(config);
    check_refresh(config);
    check_caches(config);
    check_blocks(config);
    check_pipe(config);
}

} // namespace ffgpu::timing
