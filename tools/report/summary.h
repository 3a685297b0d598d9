// The summary that replay prints: what was drawn, where the time went, what the memory carried. For
// people; tools read stats.json.

#pragma once

#include "model/timing/config/clock.h"

#include <cstddef>
#include <string>

#include <nlohmann/json_fwd.hpp>

namespace ffgpu::tools {

// `totals` as in stats.json; `clock` makes milliseconds of cycles.
std::string summarize(const nlohmann::ordered_json& totals,
                      std::size_t frames,
                      const timing::ClockConfig& clock);

} // namespace ffgpu::tools
