#pragma once

#include "driver/gl_types.h"

namespace ffgpu::gl {

struct EvaluatorState {};

} // namespace ffgpu::gl
