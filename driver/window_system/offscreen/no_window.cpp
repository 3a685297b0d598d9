// There is no window whose size could change, and no back buffer.

#include "driver/window_system/exports/window_hooks.h"

namespace ffgpu::gl {

void before_viewport() {}
void before_draw_buffer() {}

} // namespace ffgpu::gl
