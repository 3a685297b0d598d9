// A pixel's history as text for people: a paragraph an event.

#pragma once

#include "tools/explain/pixel_history.h"

#include <string>

namespace ffgpu::tools {

std::string history_text(const PixelHistory& history);

} // namespace ffgpu::tools
