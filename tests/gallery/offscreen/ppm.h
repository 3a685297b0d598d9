// Pictures as files that anything reads: binary PPM, rows from the top.

#pragma once

#include "tests/gallery/oracles/compare.h"

#include <string>

namespace ffgpu::gallery {

void write_ppm(const std::string& path, const Picture& picture);
Picture read_ppm(const std::string& path); // of the window's size, as write_ppm writes it

} // namespace ffgpu::gallery
