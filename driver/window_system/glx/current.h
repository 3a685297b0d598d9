// What glXGetCurrent... answers.

#pragma once

#include "driver/window_system/glx/display.h"

namespace ffgpu::gl {

struct GlxCurrent {
    GLXContext context = nullptr;
    Display* display = nullptr;
    GLXDrawable draw = 0, read = 0;
};

// The calling thread's; empty where nothing is current, or EGL made it so.
GlxCurrent glx_current();

} // namespace ffgpu::gl
