#pragma once

#include "driver/gl_types.h"

namespace ffgpu::gl {

struct VertexArrayState {};

} // namespace ffgpu::gl
