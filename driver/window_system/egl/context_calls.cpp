// Contexts and what is current (EGL 1.5, 3.7, 3.8).

#include "driver/window_system/egl/thread_state.h"
#include "driver/window_system/refused_version.h"

namespace ffgpu::gl {
namespace {

// Checks what eglCreateContext asks for: OpenGL 1.0 to 1.5 in any profile, debugging allowed.
void check_context_wish(const EGLint* attributes) {
    EGLint major = 1, minor = 0;
    for (const EGLint* at = attributes; at && at[0] != EGL_NONE; at += 2) {
        switch (at[0]) {
        case EGL_CONTEXT_MAJOR_VERSION:
            major = at[1];
            break;
        case EGL_CONTEXT_MINOR_VERSION:
            minor = at[1];
            break;
        case EGL_CONTEXT_OPENGL_PROFILE_MASK:
        case EGL_CONTEXT_OPENGL_DEBUG:
        case EGL_CONTEXT_FLAGS_KHR:
        case EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY:
            break;
        case EGL_CONTEXT_OPENGL_FORWARD_COMPATIBLE:
        case EGL_CONTEXT_OPENGL_ROBUST_ACCESS:
            if (at[1] != EGL_FALSE) throw EglError{EGL_BAD_MATCH};
            break;
        default:
            throw EglError{EGL_BAD_ATTRIBUTE};
        }
    }
    if (major > 1) tell_refused_version(major, minor);
    if (major != 1 || minor < 0 || minor > 5) throw EglError{EGL_BAD_MATCH};
}

EGLContext
create_context(EGLDisplay dpy, EGLConfig config, EGLContext share, const EGLint* attributes) {
    EglDisplay& display = require_display(dpy);
    const EglConfig* const of = config ? &require_config(display, config) : nullptr;
    if (egl_thread().api != EGL_OPENGL_API) throw EglError{EGL_BAD_MATCH};
    const auto shared = share ? require_context(display, share) : nullptr;
    check_context_wish(attributes);
    auto made = std::make_shared<EglContext>(of, shared.get());
    display.contexts.emplace(made.get(), made);
    return made.get();
}

EGLBoolean release() {
    if (egl_thread().is_current()) bind({});
    egl_thread().context = EGL_NO_CONTEXT;
    egl_thread().draw = egl_thread().read = EGL_NO_SURFACE;
    egl_thread().display = nullptr;
    return EGL_TRUE;
}

EGLBoolean
make_context_current(EGLDisplay dpy, EGLSurface draw, EGLSurface read, EGLContext context) {
    if (!context && !draw && !read && EglDisplay::from(dpy)) return release();
    EglDisplay& display = require_display(dpy);
    if (!context || !draw != !read) throw EglError{EGL_BAD_MATCH};
    Binding next;
    const auto wanted = require_context(display, context);
    next.context = wanted;
    if (draw) {
        next.draw = require_surface(display, draw).surface;
        next.read = require_surface(display, read).surface;
    }
    const Binding& now = current_binding();
    const auto elsewhere = [&](const auto& thing) {
        return thing && thing->bound && thing != now.draw && thing != now.read;
    };
    if (wanted->bound && now.context != wanted) throw EglError{EGL_BAD_ACCESS};
    if (elsewhere(next.draw) || elsewhere(next.read)) throw EglError{EGL_BAD_ACCESS};
    bind(std::move(next));
    EglThread& thread = egl_thread();
    thread.context = context;
    thread.display = &display;
    thread.draw = draw;
    thread.read = read;
    return EGL_TRUE;
}

EGLint query(const EglContext& context, EGLint attribute) {
    switch (attribute) {
    case EGL_CONFIG_ID:
        return context.config_id;
    case EGL_CONTEXT_CLIENT_TYPE:
        return EGL_OPENGL_API;
    case EGL_CONTEXT_CLIENT_VERSION:
        return 1;
    case EGL_RENDER_BUFFER: {
        const auto& draw = current_binding().draw;
        if (!draw || current_binding().context.get() != &context) return EGL_NONE;
        return draw->format().double_buffer ? EGL_BACK_BUFFER : EGL_SINGLE_BUFFER;
    }
    default:
        throw EglError{EGL_BAD_ATTRIBUTE};
    }
}

} // namespace
} // namespace ffgpu::gl

using namespace ffgpu::gl;

FFGPU_EGL EGLContext eglCreateContext(EGLDisplay dpy,
                                      EGLConfig config,
                                      EGLContext share,
                                      const EGLint* attributes) {
    return egl_call(EGL_NO_CONTEXT, [&] { return create_context(dpy, config, share, attributes); });
}

// A context that is current lives on until it is not any more: its binding keeps it.
FFGPU_EGL EGLBoolean eglDestroyContext(EGLDisplay dpy, EGLContext context) {
    return egl_call<EGLBoolean>(EGL_FALSE, [&] {
        EglDisplay& display = require_display(dpy);
        require_context(display, context);
        display.contexts.erase(context);
        return EGL_TRUE;
    });
}

FFGPU_EGL EGLBoolean eglMakeCurrent(EGLDisplay dpy,
                                    EGLSurface draw,
                                    EGLSurface read,
                                    EGLContext context) {
    return egl_call<EGLBoolean>(EGL_FALSE,
                                [&] { return make_context_current(dpy, draw, read, context); });
}

FFGPU_EGL EGLBoolean eglQueryContext(EGLDisplay dpy,
                                     EGLContext context,
                                     EGLint attribute,
                                     EGLint* value) {
    return egl_call<EGLBoolean>(EGL_FALSE, [&] {
        const auto known = require_context(require_display(dpy), context);
        *value = query(*known, attribute);
        return EGL_TRUE;
    });
}

FFGPU_EGL EGLContext eglGetCurrentContext() {
    const EglThread& thread = egl_thread();
    return thread.is_current() ? thread.context : EGL_NO_CONTEXT;
}

FFGPU_EGL EGLSurface eglGetCurrentSurface(EGLint which) {
    const EglThread& thread = egl_thread();
    if (which != EGL_DRAW && which != EGL_READ) {
        egl_thread().error = EGL_BAD_PARAMETER;
        return EGL_NO_SURFACE;
    }
    if (!thread.is_current()) return EGL_NO_SURFACE;
    return which == EGL_DRAW ? thread.draw : thread.read;
}

FFGPU_EGL EGLDisplay eglGetCurrentDisplay() {
    const EglThread& thread = egl_thread();
    return thread.is_current() ? thread.display : EGL_NO_DISPLAY;
}
