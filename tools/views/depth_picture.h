// Pictures of a depth target.

#pragma once

#include "model/device/device.h"
#include "tools/image/image.h"

namespace ffgpu::tools {

// What is nearest is white, what is furthest of all that is nearer than the far plane dark grey;
// the far plane is black. Sample 0 of multisampled targets.
Image depth_picture(Device& device, const Surface& target);

// Grey, white is the largest value; black where the target has no stencil.
Image stencil_picture(Device& device, const Surface& target);

} // namespace ffgpu::tools
