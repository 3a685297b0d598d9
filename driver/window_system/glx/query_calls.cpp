// What GLX is and which functions it has (GLX 1.4, 3.3.2 and 3.3.12).

#include "driver/window_system/exports/proc_address.h"
#include "driver/window_system/glx/display.h"
#include "driver/window_system/turn.h"

namespace ffgpu::gl {
namespace {

constexpr const char* Vendor = "ffgpu";
constexpr const char* Version = "1.4";
// Each works as its specification says, none needs the server.
constexpr const char* Extensions =
    "GLX_ARB_create_context GLX_ARB_create_context_profile GLX_ARB_framebuffer_sRGB "
    "GLX_ARB_get_proc_address GLX_ARB_multisample GLX_EXT_framebuffer_sRGB GLX_EXT_swap_control "
    "GLX_EXT_visual_info GLX_EXT_visual_rating "
    "GLX_MESA_query_renderer GLX_MESA_swap_control GLX_OML_swap_method GLX_SGIX_fbconfig "
    "GLX_SGI_make_current_read GLX_SGI_swap_control";

const char* string_of(int name) {
    switch (name) {
    case GLX_VENDOR:
        return Vendor;
    case GLX_VERSION:
        return Version;
    case GLX_EXTENSIONS:
        return Extensions;
    default:
        return nullptr;
    }
}

} // namespace
} // namespace ffgpu::gl

using namespace ffgpu::gl;

FFGPU_GLX Bool glXQueryExtension(Display* dpy, int* errorBase, int* eventBase) {
    const Turn turn;
    const GlxDisplay& display = GlxDisplay::of(dpy);
    if (errorBase) *errorBase = display.error_base();
    if (eventBase) *eventBase = display.event_base();
    return True;
}

FFGPU_GLX Bool glXQueryVersion(Display*, int* major, int* minor) {
    if (major) *major = 1;
    if (minor) *minor = 4;
    return True;
}

FFGPU_GLX const char* glXQueryExtensionsString(Display*, int) {
    return Extensions;
}

FFGPU_GLX const char* glXGetClientString(Display*, int name) {
    return string_of(name);
}

FFGPU_GLX const char* glXQueryServerString(Display*, int, int name) {
    return string_of(name);
}

FFGPU_GLX __GLXextFuncPtr glXGetProcAddressARB(const GLubyte* procname) {
    const std::string_view name = reinterpret_cast<const char*>(procname);
    return find_function(name);
}

FFGPU_GLX __GLXextFuncPtr glXGetProcAddress(const GLubyte* procname) {
    return glXGetProcAddressARB(procname);
}
