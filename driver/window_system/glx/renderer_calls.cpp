// GLX_MESA_query_renderer: what the library renders with, without a context.

#include "driver/window_system/glx/current.h"
#include "driver/window_system/glx/display.h"
#include "driver/window_system/process_gpu.h"
#include "driver/window_system/turn.h"

#include <charconv>
#include <cstring>

namespace ffgpu::gl {
namespace {

constexpr const char* VendorName = "ffgpu";
constexpr const char* DeviceName = "ffgpu fixed-function GPU";
constexpr unsigned NoPciDevice = 0xffffffff;

// "1.2.3" to three numbers.
void read_version(unsigned* numbers) {
    const char* at = FFGPU_VERSION;
    const char* const end = at + std::strlen(at);
    for (unsigned i = 0; i < 3; ++i) {
        numbers[i] = 0;
        at = std::from_chars(at, end, numbers[i]).ptr;
        if (at != end) ++at;
    }
}

Bool query_number(int attribute, unsigned* value) {
    switch (attribute) {
    case GLX_RENDERER_VENDOR_ID_MESA:
    case GLX_RENDERER_DEVICE_ID_MESA:
        *value = NoPciDevice;
        return True;
    case GLX_RENDERER_VERSION_MESA:
        read_version(value);
        return True;
    case GLX_RENDERER_ACCELERATED_MESA:
        *value = False;
        return True;
    case GLX_RENDERER_VIDEO_MEMORY_MESA: // in megabytes
        *value = static_cast<unsigned>(ProcessGpu::instance().device().memory_size() >> 20);
        return True;
    case GLX_RENDERER_UNIFIED_MEMORY_ARCHITECTURE_MESA:
        *value = True;
        return True;
    case GLX_RENDERER_PREFERRED_PROFILE_MESA:
        *value = GLX_CONTEXT_COMPATIBILITY_PROFILE_BIT_ARB;
        return True;
    case GLX_RENDERER_OPENGL_COMPATIBILITY_PROFILE_VERSION_MESA:
        value[0] = 1;
        value[1] = 5;
        return True;
    case GLX_RENDERER_OPENGL_CORE_PROFILE_VERSION_MESA:
    case GLX_RENDERER_OPENGL_ES_PROFILE_VERSION_MESA:
    case GLX_RENDERER_OPENGL_ES2_PROFILE_VERSION_MESA:
        value[0] = value[1] = 0; // There is none.
        return True;
    default:
        return False;
    }
}

const char* query_name(int attribute) {
    if (attribute == GLX_RENDERER_VENDOR_ID_MESA) return VendorName;
    return attribute == GLX_RENDERER_DEVICE_ID_MESA ? DeviceName : nullptr;
}

// There is one renderer for each screen, number 0.
bool exists(Display* dpy, int screen, int renderer) {
    return GlxDisplay::of(dpy).screen(screen) != nullptr && renderer == 0;
}

} // namespace
} // namespace ffgpu::gl

using namespace ffgpu::gl;

FFGPU_GLX Bool glXQueryRendererIntegerMESA(
    Display* dpy, int screen, int renderer, int attribute, unsigned* value) {
    const Turn turn;
    return exists(dpy, screen, renderer) ? query_number(attribute, value) : False;
}

FFGPU_GLX Bool glXQueryCurrentRendererIntegerMESA(int attribute, unsigned* value) {
    const Turn turn;
    return glx_current().context ? query_number(attribute, value) : False;
}

FFGPU_GLX const char*
glXQueryRendererStringMESA(Display* dpy, int screen, int renderer, int attribute) {
    const Turn turn;
    return exists(dpy, screen, renderer) ? query_name(attribute) : nullptr;
}

FFGPU_GLX const char* glXQueryCurrentRendererStringMESA(int attribute) {
    const Turn turn;
    return glx_current().context ? query_name(attribute) : nullptr;
}
