// The machine as it would be without the limits of one resource: what a bottleneck's gain means.
// Running it on the same work measures the gain that bottlenecks.h reckons.

#pragma once

#include "model/timing/config.h"
#include "model/timing/memory_module.h"
#include "model/timing/resource.h"

namespace ffgpu::timing {

// False: the machine has no such resource, or none of its parameters limits it.
bool has_limit(const TimingConfig& config, Resource resource);

// The configuration with the resource's rates as high as they can be told, and its latencies as
// short; all other units, and the places of all queues, stay as they are.
TimingConfig without_limit(TimingConfig config, Resource resource);

// The memory of a machine that came from without_limit(): it holds as many requests as that of the
// configuration it came from, whatever its latency is now.
MakeMemory memory_as_deep_as(const TimingConfig& config);

} // namespace ffgpu::timing
