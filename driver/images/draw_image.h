// Draws an image that lies in the host's memory through the fragment pipe, at the raster position
// (GL 1.5, 3.6.4 and 3.7).

#pragma once

#include "model/device/layout/formats.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ffgpu::gl {

class DeviceContext;

struct HostImage {
    Format format = Format::Rgba8; // or Depth24Stencil8, Stencil8, Bitmap
    std::uint32_t width = 0, height = 0;
    std::vector<std::byte> pixels; // rows without gaps
};

// Of the image's lower left corner.
struct ImagePlace {
    float x = 0, y = 0;
    float zoom_x = 1, zoom_y = 1;
};

// The raster position is valid; where nothing can be drawn, or device memory is full, the error is
// recorded.
void draw_image(DeviceContext& context, const HostImage& image, const ImagePlace& place);

// A Depth24Stencil8 image's depths as GL_DEPTH_STENCIL writes them: under the depth mask and the
// scissor, past all tests and past the depth test's enable (ARB_framebuffer_object, 4.3.1).
void draw_depths_untested(DeviceContext& context, const HostImage& image, const ImagePlace& place);

} // namespace ffgpu::gl
