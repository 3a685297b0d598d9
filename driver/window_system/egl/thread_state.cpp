#include "driver/window_system/egl/thread_state.h"

namespace ffgpu::gl {
namespace {
thread_local EglThread state;
}

EglThread& egl_thread() {
    return state;
}

} // namespace ffgpu::gl
