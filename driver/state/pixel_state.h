#pragma once

#include "driver/gl_types.h"

namespace ffgpu::gl {

struct PixelState {};

} // namespace ffgpu::gl
