// PNG files, by libpng.

#pragma once

#include "tools/image/image.h"

namespace ffgpu::tools {

bool is_png(const std::string& path);

// Alpha is dropped, grey and palettes are spread, 16 bits become 8. Throws InputError.
Image read_png(const std::string& path);

} // namespace ffgpu::tools
