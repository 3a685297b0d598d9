// Carries out the records of a display list (GL 1.5, 5.4).

#pragma once

#include "driver/gl_types.h"

namespace ffgpu::gl {

class Context;

// Does nothing if there is no list of this name, or if lists are nested too deeply.
void call_list(Context& context, GLuint name);

} // namespace ffgpu::gl
