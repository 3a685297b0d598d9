// Windows, pixmaps and pbuffers (GLX 1.4, 3.3.4 to 3.3.6).

#include "driver/window_system/glx/current.h"
#include "driver/window_system/glx/protocol.h"
#include "driver/window_system/turn.h"
#include "driver/window_system/x11/internals.h"
#include "model/device/layout/limits.h"

#include <algorithm>
#include <new>

namespace ffgpu::gl {
namespace {

using Kind = GlxDrawable::Kind;

GLXDrawable add(GlxDisplay& display, Display* dpy, const GlxConfig& config, GlxDrawable made) {
    const XID id = allocate_id(dpy);
    made.surface->id = id;
    made.surface->config_id = config.id;
    display.drawables[id] = std::move(made);
    return id;
}

// A window or pixmap of X.
GLXDrawable
wrap(GlxDisplay& display, Display* dpy, const GlxConfig& config, XID drawable, Kind kind) {
    const unsigned minor = kind == Kind::Pixmap ? RequestCreatePixmap : RequestCreateWindow;
    try {
        auto target = std::make_unique<XTarget>(dpy, drawable);
        if (!target->size()) {
            display.report_core(kind == Kind::Pixmap ? BadPixmap : BadWindow, minor, drawable);
            return 0;
        }
        auto surface = std::make_shared<WindowSurface>(config.format, std::move(target));
        surface->swaps = kind != Kind::Pixmap;
        return add(display, dpy, config, {.kind = kind, .surface = std::move(surface)});
    } catch (const std::bad_alloc&) {
        display.report_core(BadAlloc, minor, drawable);
        return 0;
    }
}

GLXDrawable wrap_checked(Display* dpy, GLXFBConfig handle, XID drawable, Kind kind) {
    const Turn turn;
    GlxDisplay& display = GlxDisplay::of(dpy);
    const GlxConfig* const config = display.config_of(handle);
    if (!config) {
        display.report_glx(GlxBadFbConfig,
                           kind == Kind::Pixmap ? RequestCreatePixmap : RequestCreateWindow);
        return 0;
    }
    const bool taken =
        kind == Kind::GlxWindow && std::ranges::any_of(display.drawables, [&](const auto& entry) {
            return entry.second.kind == Kind::GlxWindow &&
                   entry.second.surface->target()->drawable() == drawable;
        });
    if (taken) {
        display.report_core(BadAlloc, RequestCreateWindow, drawable);
        return 0;
    }
    return wrap(display, dpy, *config, drawable, kind);
}

void destroy(Display* dpy, GLXDrawable id, Kind kind, int error, unsigned minor) {
    const Turn turn;
    GlxDisplay& display = GlxDisplay::of(dpy);
    const auto found = display.drawables.find(id);
    if (found == display.drawables.end() || found->second.kind != kind)
        return display.report_glx(error, minor, id);
    if (id == glx_current().draw) flush_current();
    // A GLX window ends with its X window.
    const bool gone = kind == Kind::GlxWindow && !found->second.surface->target()->size();
    display.drawables.erase(found); // A thread that has it current keeps it.
    if (gone) display.report_glx(error, minor, id);
}

struct PbufferWish {
    int width = 0, height = 0;
    bool largest = false, preserved = true;
};

PbufferWish read_pbuffer_wish(const int* attributes) {
    PbufferWish wish;
    for (const int* at = attributes; at && at[0] != 0; at += 2) {
        if (at[0] == GLX_PBUFFER_WIDTH) wish.width = at[1];
        if (at[0] == GLX_PBUFFER_HEIGHT) wish.height = at[1];
        if (at[0] == GLX_LARGEST_PBUFFER) wish.largest = at[1] != 0;
        if (at[0] == GLX_PRESERVED_CONTENTS) wish.preserved = at[1] != 0;
    }
    return wish;
}

void query(const GlxDrawable& drawable, int attribute, unsigned* value) {
    const WindowSurface& surface = *drawable.surface;
    switch (attribute) {
    case GLX_WIDTH:
        *value = surface.size().width;
        break;
    case GLX_HEIGHT:
        *value = surface.size().height;
        break;
    case GLX_FBCONFIG_ID:
        *value = static_cast<unsigned>(surface.config_id);
        break;
    case GLX_PRESERVED_CONTENTS:
        if (drawable.kind == Kind::Pbuffer) *value = drawable.preserved_contents;
        break;
    case GLX_LARGEST_PBUFFER:
        if (drawable.kind == Kind::Pbuffer) *value = drawable.largest_pbuffer;
        break;
    case GLX_SWAP_INTERVAL_EXT:
        *value = 0;
        break;
    case GLX_MAX_SWAP_INTERVAL_EXT:
        *value = 1;
        break;
    default:
        break;
    }
}

} // namespace
} // namespace ffgpu::gl

using namespace ffgpu::gl;

FFGPU_GLX GLXWindow glXCreateWindow(Display* dpy, GLXFBConfig config, Window window, const int*) {
    return wrap_checked(dpy, config, window, Kind::GlxWindow);
}

FFGPU_GLX void glXDestroyWindow(Display* dpy, GLXWindow window) {
    destroy(dpy, window, Kind::GlxWindow, GlxBadWindow, RequestDestroyWindow);
}

FFGPU_GLX GLXPixmap glXCreatePixmap(Display* dpy, GLXFBConfig config, Pixmap pixmap, const int*) {
    return wrap_checked(dpy, config, pixmap, Kind::Pixmap);
}

FFGPU_GLX void glXDestroyPixmap(Display* dpy, GLXPixmap pixmap) {
    destroy(dpy, pixmap, Kind::Pixmap, GlxBadPixmap, RequestDestroyPixmap);
}

FFGPU_GLX GLXPixmap glXCreateGLXPixmap(Display* dpy, XVisualInfo* visual, Pixmap pixmap) {
    const Turn turn;
    GlxDisplay& display = GlxDisplay::of(dpy);
    const GlxConfig* const config = visual ? display.config_of(*visual) : nullptr;
    if (config) return wrap(display, dpy, *config, pixmap, Kind::Pixmap);
    display.report_core(BadMatch, RequestCreateGlxPixmap, pixmap);
    return 0;
}

FFGPU_GLX void glXDestroyGLXPixmap(Display* dpy, GLXPixmap pixmap) {
    destroy(dpy, pixmap, Kind::Pixmap, GlxBadPixmap, RequestDestroyGlxPixmap);
}

FFGPU_GLX GLXPixmap glXCreateGLXPixmapWithConfigSGIX(Display* dpy,
                                                     GLXFBConfigSGIX config,
                                                     Pixmap pixmap) {
    return wrap_checked(dpy, config, pixmap, Kind::Pixmap);
}

FFGPU_GLX GLXPbuffer glXCreatePbuffer(Display* dpy, GLXFBConfig handle, const int* attributes) {
    const Turn turn;
    GlxDisplay& display = GlxDisplay::of(dpy);
    const GlxConfig* const config = display.config_of(handle);
    const PbufferWish wish = read_pbuffer_wish(attributes);
    if (!config) {
        display.report_glx(GlxBadFbConfig, RequestCreatePbuffer);
        return 0;
    }
    constexpr int Limit = ffgpu::MaxSurfaceSize;
    const bool fits = wish.width <= Limit && wish.height <= Limit;
    if (wish.width < 0 || wish.height < 0 || (!fits && !wish.largest)) {
        display.report_core(wish.width < 0 || wish.height < 0 ? BadValue : BadAlloc,
                            RequestCreatePbuffer);
        return 0;
    }
    const Size size{static_cast<unsigned>(std::min(wish.width, Limit)),
                    static_cast<unsigned>(std::min(wish.height, Limit))};
    try {
        return add(display,
                   dpy,
                   *config,
                   {.kind = Kind::Pbuffer,
                    .surface = std::make_shared<WindowSurface>(config->format, size),
                    .preserved_contents = wish.preserved,
                    .largest_pbuffer = wish.largest});
    } catch (const std::bad_alloc&) {
        display.report_core(BadAlloc, RequestCreatePbuffer);
        return 0;
    }
}

FFGPU_GLX void glXDestroyPbuffer(Display* dpy, GLXPbuffer pbuffer) {
    destroy(dpy, pbuffer, Kind::Pbuffer, GlxBadPbuffer, RequestDestroyPbuffer);
}

FFGPU_GLX void glXQueryDrawable(Display* dpy, GLXDrawable id, int attribute, unsigned int* value) {
    const Turn turn;
    GlxDisplay& display = GlxDisplay::of(dpy);
    const auto found = display.drawables.find(id);
    if (found != display.drawables.end()) {
        found->second.surface->follow_window();
        return query(found->second, attribute, value);
    }
    XTarget window(dpy, id); // A window that was never current: its size is known.
    const auto size = window.size();
    if (!size) return display.report_glx(GlxBadDrawable, RequestGetDrawableAttributes, id);
    if (attribute == GLX_WIDTH) *value = size->width;
    if (attribute == GLX_HEIGHT) *value = size->height;
}

// Contents of pbuffers are never lost, so that no event comes.
FFGPU_GLX void glXSelectEvent(Display* dpy, GLXDrawable id, unsigned long mask) {
    const Turn turn;
    auto& drawables = GlxDisplay::of(dpy).drawables;
    if (const auto found = drawables.find(id); found != drawables.end())
        found->second.event_mask = mask & GLX_PBUFFER_CLOBBER_MASK;
}

FFGPU_GLX void glXGetSelectedEvent(Display* dpy, GLXDrawable id, unsigned long* mask) {
    const Turn turn;
    auto& drawables = GlxDisplay::of(dpy).drawables;
    const auto found = drawables.find(id);
    *mask = found != drawables.end() ? found->second.event_mask : 0;
}
