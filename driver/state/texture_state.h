#pragma once

#include "driver/gl_types.h"

namespace ffgpu::gl {

struct TextureState {};

} // namespace ffgpu::gl
