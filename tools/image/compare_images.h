// How far two pictures are apart.

#pragma once

#include "tools/image/image.h"

#include <cstdint>

namespace ffgpu::tools {

struct Difference {
    double rmse = 0;               // over R, G and B, in units of 0 to 255
    double psnr = 0;               // in dB; infinite for equal pictures
    double within_16 = 1;          // share of pixels whose worst channel is at most 16 apart
    unsigned worst_x = 0;          // the pixel that is furthest apart, the first of them
    unsigned worst_y = 0;          // from the top
    unsigned worst_difference = 0; // of its worst channel
};

// Both of the same size.
Difference compare_images(const Image& a, const Image& b);

// |a - b| a channel, times 8 so that eyes see it.
Image difference_picture(const Image& a, const Image& b);

} // namespace ffgpu::tools
