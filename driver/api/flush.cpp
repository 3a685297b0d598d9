// glFlush and glFinish (GL 1.5, 5.5).

#include "driver/commands/declarations.h"
#include "driver/context/context.h"

namespace ffgpu::gl::api {

// What waited has been submitted before (the dispatcher settles the vertices), and the device takes
// commands at once: all that is left is to show a front buffer.
void Flush(Context& context) {
    if (context.on_flush) context.on_flush();
}

void Finish(Context& context) {
    context.device().finish();
    if (context.on_flush) context.on_flush();
}

} // namespace ffgpu::gl::api
