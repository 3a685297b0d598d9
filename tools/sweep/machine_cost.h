// What a machine would cost, from the costs of units in docs/rtl_cost.md: LUTs of the fragment
// pipes, the texture units and the rasterizer, and a LUT for each 16 bits of its caches, which is
// what a LUT holds as memory. docs/sweep.md has the counts of units.

#pragma once

#include "model/timing/config.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

namespace ffgpu::tools {

using UnitCosts = std::map<std::string, std::uint64_t>; // LUTs

// Of the page's table; empty where there is none.
UnitCosts read_unit_costs(const std::filesystem::path& page);

std::uint64_t cache_bits(const timing::TimingConfig& config);
std::uint64_t machine_cost(const timing::TimingConfig& config, const UnitCosts& units);

} // namespace ffgpu::tools
