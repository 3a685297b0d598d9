// glFlush and glFinish (GL 1.5, 5.5).

#include "driver/context/context.h"
#include "driver/entry_points/declarations.h"

namespace ffgpu::gl::api {

// What waited has been submitted before (the dispatcher settles the vertices), and the device takes
// commands at once: there is nothing left to hurry.
void Flush(Context&) {}

void Finish(Context& context) {
    context.device().finish();
}

} // namespace ffgpu::gl::api
