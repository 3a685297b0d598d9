// glXMakeCurrent and its kin (GLX 1.4, 3.3.7), swaps (3.3.10) and synchronisation (3.3.8, 3.3.9).

#include "driver/window_system/glx/current.h"
#include "driver/window_system/glx/protocol.h"
#include "driver/window_system/turn.h"

#include <new>

namespace ffgpu::gl {
namespace {

thread_local GlxCurrent current;

// The surface of a drawable; a window gets one when it is made current first. Throws.
std::shared_ptr<WindowSurface>
surface_of(GlxDisplay& display, Display* dpy, GLXDrawable id, const GlxConfig& config) {
    const auto known = display.drawables.find(id);
    if (known != display.drawables.end()) {
        const auto& surface = known->second.surface;
        const bool is_window = known->second.kind == GlxDrawable::Kind::Window;
        if (!is_window || surface->bound || surface->format() == config.format) return surface;
        display.drawables.erase(known); // The same window for another kind of context.
    }
    display.sweep();
    auto target = std::make_unique<XTarget>(dpy, id);
    if (!target->size()) return nullptr;
    auto surface = std::make_shared<WindowSurface>(config.format, std::move(target));
    surface->id = id;
    surface->config_id = config.id;
    display.drawables[id] = {.surface = surface};
    return surface;
}

Bool release() {
    bind({});
    current = {};
    return True;
}

Bool make_current_checked(
    Display* dpy, GLXDrawable draw, GLXDrawable read, GLXContext handle, unsigned minor) {
    GlxDisplay& display = GlxDisplay::of(dpy);
    if (!handle && draw == 0 && read == 0) return release();
    if (!handle || (draw == 0) != (read == 0) || draw == 0) {
        display.report_core(BadMatch, minor);
        return False;
    }
    const auto found = display.contexts.find(handle);
    if (found == display.contexts.end()) {
        // Destroyed, but still current here: it may be made current with other drawables.
        if (current.context != handle) {
            display.report_glx(GlxBadContext, minor);
            return False;
        }
    }
    Binding next;
    next.context = found != display.contexts.end() ? found->second : current_binding().context;
    if (next.context->bound && current_binding().context != next.context) {
        display.report_core(BadAccess, minor); // It is current in another thread.
        return False;
    }
    next.draw = surface_of(display, dpy, draw, handle->config);
    next.read = read == draw ? next.draw : surface_of(display, dpy, read, handle->config);
    if (!next.draw || !next.read) {
        display.report_glx(GlxBadDrawable, minor, next.draw ? read : draw);
        return False;
    }
    bind(std::move(next));
    current = {handle, dpy, draw, read};
    return True;
}

Bool make_current_or_fail(
    Display* dpy, GLXDrawable draw, GLXDrawable read, GLXContext context, unsigned minor) {
    const Turn turn;
    try {
        return make_current_checked(dpy, draw, read, context, minor);
    } catch (const std::bad_alloc&) {
        GlxDisplay::of(dpy).report_core(BadAlloc, minor);
        return False;
    }
}

} // namespace

GlxCurrent glx_current() {
    const bool still = current.context && current_binding().context.get() == current.context;
    return still ? current : GlxCurrent{};
}

} // namespace ffgpu::gl

using namespace ffgpu::gl;

FFGPU_GLX Bool glXMakeCurrent(Display* dpy, GLXDrawable drawable, GLXContext context) {
    return make_current_or_fail(dpy, drawable, drawable, context, RequestMakeCurrent);
}

FFGPU_GLX Bool glXMakeContextCurrent(Display* dpy,
                                     GLXDrawable draw,
                                     GLXDrawable read,
                                     GLXContext context) {
    return make_current_or_fail(dpy, draw, read, context, RequestMakeContextCurrent);
}

FFGPU_GLX Bool glXMakeCurrentReadSGI(Display* dpy,
                                     GLXDrawable draw,
                                     GLXDrawable read,
                                     GLXContext context) {
    return make_current_or_fail(dpy, draw, read, context, RequestMakeContextCurrent);
}

FFGPU_GLX GLXContext glXGetCurrentContext() {
    return glx_current().context;
}

FFGPU_GLX Display* glXGetCurrentDisplay() {
    return glx_current().display;
}

FFGPU_GLX GLXDrawable glXGetCurrentDrawable() {
    return glx_current().draw;
}

FFGPU_GLX GLXDrawable glXGetCurrentReadDrawable() {
    return glx_current().read;
}

FFGPU_GLX GLXDrawable glXGetCurrentReadDrawableSGI() {
    return glx_current().read;
}

FFGPU_GLX void glXSwapBuffers(Display* dpy, GLXDrawable drawable) {
    const Turn turn;
    GlxDisplay& display = GlxDisplay::of(dpy);
    const GlxCurrent now = glx_current();
    try {
        // The current surface may have lost its name: the binding keeps it.
        if (now.display == dpy && now.draw == drawable)
            return swap_surface(*current_binding().draw);
        const auto found = display.drawables.find(drawable);
        if (found != display.drawables.end()) return swap_surface(*found->second.surface);
        XTarget window(dpy, drawable);
        if (!window.size()) display.report_glx(GlxBadDrawable, RequestSwapBuffers, drawable);
    } catch (const std::bad_alloc&) {
        display.report_core(BadAlloc, RequestSwapBuffers, drawable);
    }
}

FFGPU_GLX void glXWaitGL() {
    const Turn turn;
    flush_current();
}

FFGPU_GLX void glXWaitX() {
    const Turn turn;
    if (Display* const dpy = glx_current().display) XSync(dpy, False);
}
