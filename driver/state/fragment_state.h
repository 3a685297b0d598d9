#pragma once

#include "driver/gl_types.h"

namespace ffgpu::gl {

struct FragmentState {};

} // namespace ffgpu::gl
