// PNG files, by libpng.

#pragma once

#include "tools/image/image.h"

namespace ffgpu::tools {

bool is_png(const std::string& path);

// Alpha is dropped, grey and palettes are spread, 16 bits become 8. Throws InputError.
Image read_png(const std::string& path);

// The same of the content of the file `path`, which has to be whole and unchanged to its end, also
// where no pixel depends on it.
Image read_whole_png(const std::string& content, const std::string& path);

// The image as a file. Throws InputError where it is too large for one.
std::string png_bytes(const Image& image);

} // namespace ffgpu::tools
