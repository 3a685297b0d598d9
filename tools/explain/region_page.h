// One self-contained HTML page: a region of a frame, magnified, and the history of the pixel that
// is clicked on.

#pragma once

#include "tools/explain/pixel_history.h"

#include <span>
#include <string>

namespace ffgpu::tools {

struct PageRegion {
    std::string title;
    unsigned x = 0, y = 0, width = 0, height = 0; // of the picture, from the upper left
};

// Histories row by row, from the upper left.
std::string region_page(const PageRegion& region, std::span<const PixelHistory> histories);

} // namespace ffgpu::tools
