// GLX_SGI_swap_control, GLX_MESA_swap_control, GLX_EXT_swap_control: there is no display whose
// refresh a swap could wait for. Each interval is taken, and each swap happens at once.

#include "driver/window_system/glx/current.h"

namespace {
thread_local unsigned interval = 0;
}

FFGPU_GLX int glXSwapIntervalSGI(int wanted) {
    if (!ffgpu::gl::glx_current().context) return GLX_BAD_CONTEXT;
    if (wanted <= 0) return GLX_BAD_VALUE;
    interval = static_cast<unsigned>(wanted);
    return 0;
}

FFGPU_GLX int glXSwapIntervalMESA(unsigned wanted) {
    if (!ffgpu::gl::glx_current().context) return GLX_BAD_CONTEXT;
    interval = wanted;
    return 0;
}

FFGPU_GLX int glXGetSwapIntervalMESA() {
    return static_cast<int>(interval);
}

FFGPU_GLX void glXSwapIntervalEXT(Display*, GLXDrawable, int) {}
