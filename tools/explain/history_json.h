// A pixel's history as JSON; docs/explain.md names the keys.

#pragma once

#include "tools/explain/pixel_history.h"

#include <nlohmann/json.hpp>

namespace ffgpu::tools {

nlohmann::ordered_json history_json(const PixelHistory& history);

} // namespace ffgpu::tools
