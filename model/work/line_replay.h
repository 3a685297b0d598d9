// A cache without a clock: the misses of a recorded sequence of look-ups. Here optimal replacement
// can be had, which needs the look-ups to come: no policy of the same shape misses less often.

#pragma once

#include "model/work/cache_policy.h"

#include <cstdint>
#include <span>
#include <vector>

namespace ffgpu::work {

// For each look-up the position of the next one of the same line, or NeverUsedAgain.
std::vector<std::uint64_t> next_uses(std::span<const std::uint64_t> lines);

// How many of the look-ups miss in a cache that is empty at first.
std::uint64_t count_misses(std::span<const std::uint64_t> lines,
                           std::uint32_t sets,
                           std::uint32_t ways,
                           const CachePolicy& policy);

} // namespace ffgpu::work
