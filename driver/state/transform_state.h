#pragma once

#include "driver/gl_types.h"

namespace ffgpu::gl {

struct TransformState {};

} // namespace ffgpu::gl
