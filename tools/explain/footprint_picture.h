// A picture of what a pixel's fragments read of their textures: a row a fragment and unit, a panel
// a level (and layer). A panel shows the texels around those that are read, magnified, the lowest
// row below. A texel that is read has a white frame; the bar at its foot is its share in the
// colour, the panel's full width being all of it. A dark strip stands for texels left out.

#pragma once

#include "tools/explain/pixel_history.h"
#include "tools/image/image.h"

namespace ffgpu::tools {

// No pixels where nothing is read.
Image footprint_picture(const FrameTape& tape, const PixelHistory& history);

} // namespace ffgpu::tools
