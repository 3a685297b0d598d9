// A difference as text: what parts, where, with both values, and how to look at it again.

#pragma once

#include "tools/diff/difference.h"

#include <string>

namespace ffgpu::tools {

std::string difference_text(const DiffOptions& options, const Difference& difference);

} // namespace ffgpu::tools
