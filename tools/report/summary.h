// The summary that replay prints: what was drawn, where the time went, what the memory carried. For
// people; tools read stats.json.

#pragma once

#include <cstddef>
#include <string>

#include <nlohmann/json_fwd.hpp>

namespace ffgpu::tools {

// `totals` as in stats.json.
std::string summarize(const nlohmann::ordered_json& totals, std::size_t frames);

} // namespace ffgpu::tools
