// The window-system calls by name, and where their arguments stand.

#include "driver/trace/player/window_system.h"

namespace ffgpu::trace {
namespace {

// Handles come as addresses or as numbers.
std::uint64_t handle(const Value& value) {
    return to_number<std::uint64_t>(value);
}

bool failed(const Call& call) {
    return call.result().kind == ValueKind::Bool && call.result().bits == 0;
}

// The value that follows `name` in an attribute list; 0 where it is missing.
std::int64_t attribute(const Value& list, std::uint64_t name) {
    if (list.kind != ValueKind::Array) return 0;
    bool is_name = true, found = false;
    std::int64_t result = 0;
    Call::for_each(list, [&](const Value& value) {
        if (is_name) {
            found = to_number<std::uint64_t>(value) == name;
        } else if (found) {
            result = to_number<std::int64_t>(value);
        }
        is_name = !is_name;
    });
    return result;
}

// From GL/glx.h and EGL/egl.h, which bring macros named Bool and None.
constexpr std::uint64_t GlxPbufferHeight = 0x8040, GlxPbufferWidth = 0x8041;
constexpr std::uint64_t EglHeight = 0x3056, EglWidth = 0x3057;

} // namespace

void WindowSystem::glx_create_context(const Call& call) {
    const Value& share = call.argument("shareList");
    create_context(handle(call.result()),
                   handle(share.is_null() ? call.argument("share_context") : share));
}

void WindowSystem::glx_make_current(const Call& call) {
    if (failed(call)) return;
    const auto drawable = handle(call.argument(1));
    make_current(call.thread(), {handle(call.argument(2)), drawable, drawable});
}

void WindowSystem::glx_make_context_current(const Call& call) {
    if (failed(call)) return;
    make_current(call.thread(),
                 {handle(call.argument(3)), handle(call.argument(1)), handle(call.argument(2))});
}

// A context that is current lives on until it is not (GLX 1.4, 3.3.7).
void WindowSystem::glx_destroy_context(const Call& call) {
    if (!is_current_somewhere(handle(call.argument(1)))) destroy_context(handle(call.argument(1)));
}

void WindowSystem::glx_create_pbuffer(const Call& call) {
    if (call.name() == "glXCreateGLXPbufferSGIX")
        return create_pbuffer(handle(call.result()),
                              to_number<std::int64_t>(call.argument("width")),
                              to_number<std::int64_t>(call.argument("height")));
    const Value& attributes = call.argument(2);
    create_pbuffer(handle(call.result()),
                   attribute(attributes, GlxPbufferWidth),
                   attribute(attributes, GlxPbufferHeight));
}

void WindowSystem::glx_destroy_drawable(const Call& call) {
    destroy_drawable(handle(call.argument(1)));
}

void WindowSystem::glx_swap_buffers(const Call& call) {
    swap_buffers(handle(call.argument(1)));
}

void WindowSystem::egl_create_context(const Call& call) {
    create_context(handle(call.result()), handle(call.argument(2)));
}

void WindowSystem::egl_make_current(const Call& call) {
    if (failed(call)) return;
    make_current(call.thread(),
                 {handle(call.argument(3)), handle(call.argument(1)), handle(call.argument(2))});
}

void WindowSystem::egl_destroy_context(const Call& call) {
    glx_destroy_context(call);
}

void WindowSystem::egl_create_pbuffer(const Call& call) {
    const Value& attributes = call.argument(2);
    create_pbuffer(
        handle(call.result()), attribute(attributes, EglWidth), attribute(attributes, EglHeight));
}

void WindowSystem::egl_destroy_surface(const Call& call) {
    glx_destroy_drawable(call);
}

void WindowSystem::egl_swap_buffers(const Call& call) {
    swap_buffers(handle(call.argument(1)));
}

void WindowSystem::wgl_create_context(const Call& call) {
    create_context(handle(call.result()), handle(call.argument("hShareContext")));
}

void WindowSystem::wgl_make_current(const Call& call) {
    if (failed(call)) return;
    const auto drawable = handle(call.argument(0));
    make_current(call.thread(), {handle(call.argument(1)), drawable, drawable});
}

void WindowSystem::wgl_make_context_current(const Call& call) {
    if (failed(call)) return;
    make_current(call.thread(),
                 {handle(call.argument(2)), handle(call.argument(0)), handle(call.argument(1))});
}

// Only a context that owns nothing yet may be given another's objects, so that it can be made anew.
void WindowSystem::wgl_share_lists(const Call& call) {
    if (!failed(call)) create_context(handle(call.argument(1)), handle(call.argument(0)));
}

void WindowSystem::wgl_delete_context(const Call& call) {
    if (!failed(call)) destroy_context(handle(call.argument(0)));
}

void WindowSystem::wgl_swap_buffers(const Call& call) {
    swap_buffers(handle(call.argument(0)));
}

void WindowSystem::cgl_create_context(const Call& call) {
    const Value& made = call.argument(2);
    if (made.kind != ValueKind::Array)
        return create_context(handle(made), handle(call.argument(1)));
    Call::for_each(made, [&](const Value& context) {
        create_context(handle(context), handle(call.argument(1)));
    });
}

// A CGL context has one drawable, which is set by calls of the window library: it goes by the
// context's handle.
void WindowSystem::cgl_set_current_context(const Call& call) {
    const auto context = handle(call.argument(0));
    make_current(call.thread(), {context, context, context});
}

void WindowSystem::cgl_destroy_context(const Call& call) {
    destroy_context(handle(call.argument(0)));
}

void WindowSystem::cgl_flush_drawable(const Call& call) {
    swap_buffers(handle(call.argument(0)));
}

bool WindowSystem::is_current_somewhere(Handle context) const {
    for (const auto& [thread, binding] : bindings_)
        if (binding.context == context) return true;
    return false;
}

WindowSystem::Handler WindowSystem::find(std::string_view name) {
    using W = WindowSystem;
    static const std::map<std::string_view, Handler> handlers{
        {"glXCreateContext", &W::glx_create_context},
        {"glXCreateNewContext", &W::glx_create_context},
        {"glXCreateContextAttribsARB", &W::glx_create_context},
        {"glXCreateContextWithConfigSGIX", &W::glx_create_context},
        {"glXMakeCurrent", &W::glx_make_current},
        {"glXMakeContextCurrent", &W::glx_make_context_current},
        {"glXMakeCurrentReadSGI", &W::glx_make_context_current},
        {"glXDestroyContext", &W::glx_destroy_context},
        {"glXCreatePbuffer", &W::glx_create_pbuffer},
        {"glXCreateGLXPbufferSGIX", &W::glx_create_pbuffer},
        {"glXDestroyPbuffer", &W::glx_destroy_drawable},
        {"glXDestroyGLXPbufferSGIX", &W::glx_destroy_drawable},
        {"glXDestroyWindow", &W::glx_destroy_drawable},
        {"glXDestroyPixmap", &W::glx_destroy_drawable},
        {"glXDestroyGLXPixmap", &W::glx_destroy_drawable},
        {"glXSwapBuffers", &W::glx_swap_buffers},
        {"glXSwapBuffersMscOML", &W::glx_swap_buffers},
        {"eglCreateContext", &W::egl_create_context},
        {"eglMakeCurrent", &W::egl_make_current},
        {"eglDestroyContext", &W::egl_destroy_context},
        {"eglCreatePbufferSurface", &W::egl_create_pbuffer},
        {"eglDestroySurface", &W::egl_destroy_surface},
        {"eglSwapBuffers", &W::egl_swap_buffers},
        {"eglSwapBuffersWithDamageEXT", &W::egl_swap_buffers},
        {"eglSwapBuffersWithDamageKHR", &W::egl_swap_buffers},
        {"wglCreateContext", &W::wgl_create_context},
        {"wglCreateContextAttribsARB", &W::wgl_create_context},
        {"wglCreateLayerContext", &W::wgl_create_context},
        {"wglMakeCurrent", &W::wgl_make_current},
        {"wglMakeContextCurrentARB", &W::wgl_make_context_current},
        {"wglMakeContextCurrentEXT", &W::wgl_make_context_current},
        {"wglShareLists", &W::wgl_share_lists},
        {"wglDeleteContext", &W::wgl_delete_context},
        {"wglSwapBuffers", &W::wgl_swap_buffers},
        {"wglSwapLayerBuffers", &W::wgl_swap_buffers},
        {"CGLCreateContext", &W::cgl_create_context},
        {"CGLSetCurrentContext", &W::cgl_set_current_context},
        {"CGLDestroyContext", &W::cgl_destroy_context},
        {"CGLReleaseContext", &W::cgl_destroy_context},
        {"CGLFlushDrawable", &W::cgl_flush_drawable},
    };
    const auto found = handlers.find(name);
    return found == handlers.end() ? nullptr : found->second;
}

bool WindowSystem::hands_over(std::string_view name) {
    using W = WindowSystem;
    const Handler handler = find(name);
    return handler == &W::glx_swap_buffers || handler == &W::egl_swap_buffers ||
           handler == &W::wgl_swap_buffers || handler == &W::cgl_flush_drawable;
}

bool WindowSystem::is_harmless(std::string_view name) {
    for (const std::string_view start : {"glXChoose",
                                         "glXGet",
                                         "glXQuery",
                                         "glXIs",
                                         "glXWait",
                                         "glXSwapInterval",
                                         "glXSelectEvent",
                                         "glXCreateWindow",
                                         "glXCreatePixmap",
                                         "glXCreateGLXPixmap",
                                         "glXCreateGLXVideoSource",
                                         "eglChoose",
                                         "eglGet",
                                         "eglQuery",
                                         "eglInitialize",
                                         "eglTerminate",
                                         "eglReleaseThread",
                                         "eglBindAPI",
                                         "eglSwapInterval",
                                         "eglSurfaceAttrib",
                                         "eglWait",
                                         "eglCreateWindowSurface",
                                         "eglCreatePlatformWindowSurface",
                                         "wglChoose",
                                         "wglGet",
                                         "wglSetPixelFormat",
                                         "wglDescribePixelFormat",
                                         "wglSwapInterval",
                                         "CGLChoose",
                                         "CGLGet",
                                         "CGLSet",
                                         "CGLDescribe",
                                         "CGLDestroyPixelFormat",
                                         "CGLReleasePixelFormat",
                                         "CGLRetain",
                                         "CGLError"})
        if (name.starts_with(start)) return true;
    return false;
}

} // namespace ffgpu::trace
