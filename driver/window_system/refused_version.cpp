#include "driver/window_system/refused_version.h"

#include "driver/window_system/run_mark.h"

#include <atomic>
#include <cerrno>
#include <cstdio>

namespace ffgpu::gl {

void tell_refused_version(int major, int minor) {
    static std::atomic_flag told;
    if (!RunMark::is_there() || told.test_and_set()) return;
    std::fprintf(stderr,
                 "ffgpu: warning: %s asks for a context of OpenGL %d.%d and does not get it: ffgpu "
                 "is a fixed-function GPU, of OpenGL 1.5 without shaders\n",
                 ::program_invocation_short_name,
                 major,
                 minor);
}

} // namespace ffgpu::gl
