// Small letters in a picture, for legends: lower case, digits and a few signs; white.

#pragma once

#include "tools/image/image.h"

#include <string_view>

namespace ffgpu::tools {

constexpr unsigned SmallTextHeight = 7, SmallTextAdvance = 6; // in pixels; per character

constexpr unsigned small_text_width(std::string_view text) {
    return SmallTextAdvance * static_cast<unsigned>(text.size());
}

// (x, y) is the upper left corner. What lies outside, and unknown characters, are left out.
void draw_small_text(Image& image, unsigned x, unsigned y, std::string_view text);

} // namespace ffgpu::tools
