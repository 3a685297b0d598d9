// What EGL keeps for each thread: the last error, the bound API, and what is current.

#pragma once

#include "driver/window_system/egl/display.h"
#include "driver/window_system/turn.h"

#include <new>

namespace ffgpu::gl {

struct EglThread {
    EGLint error = EGL_SUCCESS;
    EGLenum api = EGL_NONE; // OpenGL ES would be the default, which there is none of.
    EGLContext context = EGL_NO_CONTEXT;
    EglDisplay* display = nullptr;
    EGLSurface draw = EGL_NO_SURFACE, read = EGL_NO_SURFACE;

    // Something is current, and EGL made it so.
    bool is_current() const {
        return context && current_binding().context.get() ==
                              static_cast<RenderContext*>(static_cast<EglContext*>(context));
    }
};
EglThread& egl_thread();

// A call that fails: leaves the error for eglGetError.
struct EglError {
    EGLint code;
};

// Runs a call in a Turn; what it throws becomes the thread's error, and the result then is
// `failed`.
template <class Result, class Call>
Result egl_call(Result failed, Call&& call) noexcept {
    const Turn turn;
    EGLint& error = egl_thread().error;
    error = EGL_SUCCESS;
    try {
        return static_cast<Result>(call()); // EGL_TRUE is an int, EGLBoolean unsigned.
    } catch (const EglError& thrown) {
        error = thrown.code;
    } catch (const std::bad_alloc&) {
        error = EGL_BAD_ALLOC;
    }
    return failed;
}

// The display behind a handle, if it is initialized; throws otherwise.
inline EglDisplay& require_display(EGLDisplay handle) {
    EglDisplay* const display = EglDisplay::from(handle);
    if (!display) throw EglError{EGL_BAD_DISPLAY};
    if (!display->initialized()) throw EglError{EGL_NOT_INITIALIZED};
    return *display;
}

inline const EglConfig& require_config(const EglDisplay& display, EGLConfig handle) {
    const EglConfig* const config = display.config(handle);
    if (!config) throw EglError{EGL_BAD_CONFIG};
    return *config;
}

inline EglSurface& require_surface(EglDisplay& display, EGLSurface handle) {
    EglSurface* const surface = display.surface(handle);
    if (!surface) throw EglError{EGL_BAD_SURFACE};
    return *surface;
}

inline std::shared_ptr<EglContext> require_context(const EglDisplay& display, EGLContext handle) {
    auto context = display.context(handle);
    if (!context) throw EglError{EGL_BAD_CONTEXT};
    return context;
}

} // namespace ffgpu::gl
