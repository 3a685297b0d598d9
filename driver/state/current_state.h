#pragma once

#include "driver/gl_types.h"

namespace ffgpu::gl {

struct CurrentState {};

} // namespace ffgpu::gl
