// What changes a pixel beside fragments: clears, copies, uploads, stencil images.

#pragma once

#include "tools/explain/pixel_history.h"

#include <optional>

namespace ffgpu::tools {

// What the step does to the place, with these registers; nothing: it does not reach it. The event
// has no values yet.
std::optional<PixelEvent>
change_of(const TapeStep& step, const Registers& registers, const PixelPlace& place);

} // namespace ffgpu::tools
