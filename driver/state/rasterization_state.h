#pragma once

#include "driver/gl_types.h"

namespace ffgpu::gl {

struct RasterizationState {};

} // namespace ffgpu::gl
