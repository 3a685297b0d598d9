#pragma once

#include "driver/gl_types.h"

namespace ffgpu::gl {

struct LightingState {};

} // namespace ffgpu::gl
