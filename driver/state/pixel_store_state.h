#pragma once

#include "driver/gl_types.h"

namespace ffgpu::gl {

struct PixelStoreState {};

} // namespace ffgpu::gl
