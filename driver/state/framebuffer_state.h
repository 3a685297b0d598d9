#pragma once

#include "driver/gl_types.h"

namespace ffgpu::gl {

struct FramebufferState {};

} // namespace ffgpu::gl
