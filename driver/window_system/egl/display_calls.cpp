// Displays, strings and threads (EGL 1.5, 3.1 to 3.3, 3.12).

#include "driver/window_system/egl/thread_state.h"
#include "driver/window_system/exports/proc_address.h"

#include <cstdlib>

namespace ffgpu::gl {
namespace {

constexpr const char* ClientExtensions =
    "EGL_EXT_client_extensions EGL_EXT_platform_base EGL_EXT_platform_x11 EGL_KHR_platform_x11 "
    "EGL_KHR_client_get_all_proc_addresses EGL_MESA_platform_surfaceless";
constexpr const char* DisplayExtensions =
    "EGL_KHR_create_context EGL_KHR_fence_sync EGL_KHR_get_all_proc_addresses "
    "EGL_KHR_no_config_context EGL_KHR_surfaceless_context EGL_KHR_wait_sync";

EglPlatform platform_of(EGLenum name) {
    if (name == EGL_PLATFORM_X11_KHR) return EglPlatform::X11;
    if (name == EGL_PLATFORM_SURFACELESS_MESA) return EglPlatform::Surfaceless;
    throw EglError{EGL_BAD_PARAMETER};
}

EGLDisplay platform_display(EGLenum platform, void* native) {
    return egl_call(EGL_NO_DISPLAY, [&]() -> EGLDisplay {
        return EglDisplay::get(platform_of(platform), static_cast<Display*>(native));
    });
}

const char* display_string(EGLDisplay dpy, EGLint name) {
    if (!dpy && name == EGL_EXTENSIONS) return ClientExtensions;
    if (!dpy && name == EGL_VERSION) return "1.5";
    require_display(dpy);
    switch (name) {
    case EGL_CLIENT_APIS:
        return "OpenGL";
    case EGL_EXTENSIONS:
        return DisplayExtensions;
    case EGL_VENDOR:
        return "ffgpu";
    case EGL_VERSION:
        return "1.5 ffgpu";
    default:
        throw EglError{EGL_BAD_PARAMETER};
    }
}

} // namespace
} // namespace ffgpu::gl

using namespace ffgpu::gl;

// The default is the X server that DISPLAY names, or none.
FFGPU_EGL EGLDisplay eglGetDisplay(EGLNativeDisplayType native) {
    const bool has_server = native || std::getenv("DISPLAY");
    return platform_display(has_server ? EGL_PLATFORM_X11_KHR : EGL_PLATFORM_SURFACELESS_MESA,
                            native);
}

FFGPU_EGL EGLDisplay eglGetPlatformDisplay(EGLenum platform, void* native, const EGLAttrib*) {
    return platform_display(platform, native);
}

FFGPU_EGL EGLDisplay eglGetPlatformDisplayEXT(EGLenum platform, void* native, const EGLint*) {
    return platform_display(platform, native);
}

FFGPU_EGL EGLBoolean eglInitialize(EGLDisplay dpy, EGLint* major, EGLint* minor) {
    return egl_call<EGLBoolean>(EGL_FALSE, [&] {
        EglDisplay* const display = EglDisplay::from(dpy);
        if (!display) throw EglError{EGL_BAD_DISPLAY};
        if (!display->initialize()) throw EglError{EGL_NOT_INITIALIZED};
        if (major) *major = 1;
        if (minor) *minor = 5;
        return EGL_TRUE;
    });
}

FFGPU_EGL EGLBoolean eglTerminate(EGLDisplay dpy) {
    return egl_call<EGLBoolean>(EGL_FALSE, [&] {
        EglDisplay* const display = EglDisplay::from(dpy);
        if (!display) throw EglError{EGL_BAD_DISPLAY};
        display->terminate();
        return EGL_TRUE;
    });
}

FFGPU_EGL const char* eglQueryString(EGLDisplay dpy, EGLint name) {
    return egl_call<const char*>(nullptr, [&] { return display_string(dpy, name); });
}

FFGPU_EGL EGLint eglGetError() {
    return std::exchange(egl_thread().error, EGL_SUCCESS);
}

FFGPU_EGL EGLBoolean eglBindAPI(EGLenum api) {
    return egl_call<EGLBoolean>(EGL_FALSE, [&] {
        if (api != EGL_OPENGL_API) throw EglError{EGL_BAD_PARAMETER};
        egl_thread().api = api;
        return EGL_TRUE;
    });
}

FFGPU_EGL EGLenum eglQueryAPI() {
    return egl_thread().api;
}

FFGPU_EGL EGLBoolean eglReleaseThread() {
    return egl_call<EGLBoolean>(EGL_FALSE, [&] {
        if (egl_thread().is_current()) bind({});
        egl_thread() = {};
        return EGL_TRUE;
    });
}

FFGPU_EGL __eglMustCastToProperFunctionPointerType eglGetProcAddress(const char* name) {
    return find_function(name);
}
