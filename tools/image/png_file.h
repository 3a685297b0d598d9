// PNG files, by libpng.

#pragma once

#include "tools/image/image.h"

namespace ffgpu::tools {

bool is_png(const std::string& path);

// Alpha is dropped, grey and palettes are spread, 16 bits become 8. Throws InputError.
Image read_png(const std::string& path);

// Without reading the pixels. Throws InputError where the file is no PNG.
struct PngSize {
    std::uint32_t width = 0, height = 0;
};
PngSize png_size(const std::string& path);

// The image as a file. Throws InputError where it is too large for one.
std::string png_bytes(const Image& image);

} // namespace ffgpu::tools
