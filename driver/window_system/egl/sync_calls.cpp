// Synchronisation (EGL 1.5, 3.8.1 and 3.9). The device carries out commands in order, and a fence
// is passed once what was called before it is flushed: each fence is signaled when it is made.

#include "driver/window_system/egl/thread_state.h"

namespace ffgpu::gl {
namespace {

EGLSync create_sync(EGLDisplay dpy, EGLenum type, bool has_attributes) {
    EglDisplay& display = require_display(dpy);
    if (type != EGL_SYNC_FENCE) throw EglError{EGL_BAD_PARAMETER};
    if (has_attributes) throw EglError{EGL_BAD_ATTRIBUTE};
    if (!egl_thread().is_current()) throw EglError{EGL_BAD_MATCH};
    flush_current();
    static std::uintptr_t last = 0;
    const auto handle = reinterpret_cast<EGLSync>(++last);
    display.syncs.emplace(handle, type);
    return handle;
}

EGLenum require_sync(EGLDisplay dpy, EGLSync sync) {
    const EglDisplay& display = require_display(dpy);
    const auto found = display.syncs.find(sync);
    if (found == display.syncs.end()) throw EglError{EGL_BAD_PARAMETER};
    return found->second;
}

EGLAttrib sync_attribute(EGLenum type, EGLint attribute) {
    switch (attribute) {
    case EGL_SYNC_TYPE:
        return type;
    case EGL_SYNC_STATUS:
        return EGL_SIGNALED;
    case EGL_SYNC_CONDITION:
        return EGL_SYNC_PRIOR_COMMANDS_COMPLETE;
    default:
        throw EglError{EGL_BAD_ATTRIBUTE};
    }
}

} // namespace
} // namespace ffgpu::gl

using namespace ffgpu::gl;

FFGPU_EGL EGLSync eglCreateSync(EGLDisplay dpy, EGLenum type, const EGLAttrib* attributes) {
    const bool some = attributes && attributes[0] != EGL_NONE;
    return egl_call(EGL_NO_SYNC, [&] { return create_sync(dpy, type, some); });
}

FFGPU_EGL EGLSyncKHR eglCreateSyncKHR(EGLDisplay dpy, EGLenum type, const EGLint* attributes) {
    const bool some = attributes && attributes[0] != EGL_NONE;
    return egl_call(EGL_NO_SYNC, [&] { return create_sync(dpy, type, some); });
}

FFGPU_EGL EGLBoolean eglDestroySync(EGLDisplay dpy, EGLSync sync) {
    return egl_call<EGLBoolean>(EGL_FALSE, [&] {
        require_sync(dpy, sync);
        require_display(dpy).syncs.erase(sync);
        return EGL_TRUE;
    });
}

FFGPU_EGL EGLBoolean eglDestroySyncKHR(EGLDisplay dpy, EGLSyncKHR sync) {
    return eglDestroySync(dpy, sync);
}

FFGPU_EGL EGLint eglClientWaitSync(EGLDisplay dpy, EGLSync sync, EGLint, EGLTime) {
    return egl_call<EGLint>(EGL_FALSE, [&] {
        require_sync(dpy, sync);
        return EGL_CONDITION_SATISFIED;
    });
}

FFGPU_EGL EGLint eglClientWaitSyncKHR(EGLDisplay dpy,
                                      EGLSyncKHR sync,
                                      EGLint flags,
                                      EGLTimeKHR timeout) {
    return eglClientWaitSync(dpy, sync, flags, timeout);
}

FFGPU_EGL EGLBoolean eglWaitSync(EGLDisplay dpy, EGLSync sync, EGLint flags) {
    return egl_call<EGLBoolean>(EGL_FALSE, [&] {
        require_sync(dpy, sync);
        if (flags != 0) throw EglError{EGL_BAD_PARAMETER};
        return EGL_TRUE;
    });
}

FFGPU_EGL EGLint eglWaitSyncKHR(EGLDisplay dpy, EGLSyncKHR sync, EGLint flags) {
    return static_cast<EGLint>(eglWaitSync(dpy, sync, flags));
}

FFGPU_EGL EGLBoolean eglGetSyncAttrib(EGLDisplay dpy,
                                      EGLSync sync,
                                      EGLint attribute,
                                      EGLAttrib* value) {
    return egl_call<EGLBoolean>(EGL_FALSE, [&] {
        *value = sync_attribute(require_sync(dpy, sync), attribute);
        return EGL_TRUE;
    });
}

FFGPU_EGL EGLBoolean eglGetSyncAttribKHR(EGLDisplay dpy,
                                         EGLSyncKHR sync,
                                         EGLint attribute,
                                         EGLint* value) {
    return egl_call<EGLBoolean>(EGL_FALSE, [&] {
        *value = static_cast<EGLint>(sync_attribute(require_sync(dpy, sync), attribute));
        return EGL_TRUE;
    });
}

FFGPU_EGL EGLBoolean eglWaitClient() {
    return egl_call<EGLBoolean>(EGL_FALSE, [] {
        flush_current();
        return EGL_TRUE;
    });
}

FFGPU_EGL EGLBoolean eglWaitGL() {
    return eglWaitClient();
}

FFGPU_EGL EGLBoolean eglWaitNative(EGLint engine) {
    return egl_call<EGLBoolean>(EGL_FALSE, [&] {
        if (engine != EGL_CORE_NATIVE_ENGINE) throw EglError{EGL_BAD_PARAMETER};
        const EglThread& thread = egl_thread();
        if (thread.is_current() && thread.display->native()) XSync(thread.display->native(), False);
        return EGL_TRUE;
    });
}

// Images are made of what other clients of EGL draw; there is none but OpenGL, whose textures
// EGL_KHR_gl_image would offer.
FFGPU_EGL EGLImage
eglCreateImage(EGLDisplay dpy, EGLContext, EGLenum, EGLClientBuffer, const EGLAttrib*) {
    return egl_call(EGL_NO_IMAGE, [&]() -> EGLImage {
        require_display(dpy);
        throw EglError{EGL_BAD_PARAMETER};
    });
}

FFGPU_EGL EGLBoolean eglDestroyImage(EGLDisplay dpy, EGLImage) {
    return egl_call<EGLBoolean>(EGL_FALSE, [&]() -> EGLBoolean {
        require_display(dpy);
        throw EglError{EGL_BAD_PARAMETER};
    });
}
