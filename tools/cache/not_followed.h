// What of a configured machine its look-ups, and the curves of them, do not follow: a line each.

#pragma once

#include "model/timing/config.h"
#include "model/work/lookups.h"

#include <span>
#include <string>
#include <vector>

namespace ffgpu::tools {

// By the look-ups of these clients (work::LookupWalk, work::TexelScan).
std::vector<std::string> not_followed_by_lookups(const timing::TimingConfig& timing,
                                                 std::span<const work::LookupClient> clients);

// By their curves, which are of one cache whose sets are the lowest bits: that, and the same.
std::vector<std::string> not_followed_by_curves(const timing::TimingConfig& timing,
                                                std::span<const work::LookupClient> clients);

} // namespace ffgpu::tools
