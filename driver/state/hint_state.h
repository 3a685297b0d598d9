#pragma once

#include "driver/gl_types.h"

namespace ffgpu::gl {

struct HintState {};

} // namespace ffgpu::gl
