// Rendering contexts (GLX 1.4, 3.3.7; GLX_ARB_create_context).

#include "driver/window_system/glx/current.h"
#include "driver/window_system/glx/display.h"
#include "driver/window_system/glx/protocol.h"
#include "driver/window_system/turn.h"

#include <new>
#include <optional>

namespace ffgpu::gl {
namespace {

GLXContext create(
    GlxDisplay& display, Display* dpy, const GlxConfig& config, GLXContext share, unsigned minor) {
    if (share && !display.contexts.contains(share)) {
        display.report_glx(GlxBadContext, minor);
        return nullptr;
    }
    try {
        auto made = std::make_shared<GlxContext>(dpy, config, share);
        display.contexts.emplace(made.get(), made);
        return made.get();
    } catch (const std::bad_alloc&) {
        display.report_core(BadAlloc, minor);
        return nullptr;
    }
}

// What glXCreateContextAttribsARB asks for, or the error that it makes.
struct ContextWish {
    int major = 1, minor = 0;
    int render_type = GLX_RGBA_TYPE;
    bool valid = true;      // else BadValue
    bool supported = true;  // else GlxBadFbConfig
    bool consistent = true; // else BadMatch
};

ContextWish read_context_wish(const int* attributes) {
    ContextWish wish;
    for (const int* at = attributes; at && at[0] != 0; at += 2) {
        switch (at[0]) {
        case GLX_CONTEXT_MAJOR_VERSION_ARB:
            wish.major = at[1];
            break;
        case GLX_CONTEXT_MINOR_VERSION_ARB:
            wish.minor = at[1];
            break;
        case GLX_CONTEXT_FLAGS_ARB:
            if (at[1] & ~(GLX_CONTEXT_DEBUG_BIT_ARB | GLX_CONTEXT_FORWARD_COMPATIBLE_BIT_ARB))
                wish.valid = false;
            // Only of OpenGL 3.0 and later.
            if (at[1] & GLX_CONTEXT_FORWARD_COMPATIBLE_BIT_ARB) wish.consistent = false;
            break;
        case GLX_RENDER_TYPE:
            wish.render_type = at[1];
            break;
        default:
            wish.valid = false;
        }
    }
    wish.supported = wish.major == 1 && wish.minor >= 0 && wish.minor <= 5;
    if (wish.major < 1 || wish.minor < 0 || (wish.major == 1 && wish.minor > 5))
        wish.consistent = false;
    return wish;
}

} // namespace
} // namespace ffgpu::gl

using namespace ffgpu::gl;

FFGPU_GLX GLXContext glXCreateContext(Display* dpy, XVisualInfo* visual, GLXContext share, Bool) {
    const Turn turn;
    GlxDisplay& display = GlxDisplay::of(dpy);
    const GlxConfig* const config = visual ? display.config_of(*visual) : nullptr;
    if (!config) {
        display.report_core(BadValue, RequestCreateContext, visual ? visual->visualid : 0);
        return nullptr;
    }
    return create(display, dpy, *config, share, RequestCreateContext);
}

FFGPU_GLX GLXContext
glXCreateNewContext(Display* dpy, GLXFBConfig handle, int render_type, GLXContext share, Bool) {
    const Turn turn;
    GlxDisplay& display = GlxDisplay::of(dpy);
    const GlxConfig* const config = display.config_of(handle);
    if (!config) {
        display.report_glx(GlxBadFbConfig, RequestCreateNewContext);
        return nullptr;
    }
    if (render_type != GLX_RGBA_TYPE) {
        const bool known = render_type == GLX_COLOR_INDEX_TYPE;
        display.report_core(known ? BadMatch : BadValue, RequestCreateNewContext);
        return nullptr;
    }
    return create(display, dpy, *config, share, RequestCreateNewContext);
}

FFGPU_GLX GLXContext glXCreateContextAttribsARB(
    Display* dpy, GLXFBConfig handle, GLXContext share, Bool, const int* attributes) {
    constexpr unsigned Minor = RequestCreateContextAttribs;
    const Turn turn;
    GlxDisplay& display = GlxDisplay::of(dpy);
    const ContextWish wish = read_context_wish(attributes);
    const GlxConfig* const config = display.config_of(handle);
    if (!wish.valid) {
        display.report_core(BadValue, Minor);
    } else if (!config || (wish.consistent && !wish.supported)) {
        display.report_glx(GlxBadFbConfig, Minor);
    } else if (!wish.consistent || wish.render_type != GLX_RGBA_TYPE) {
        display.report_core(BadMatch, Minor);
    } else {
        return create(display, dpy, *config, share, Minor);
    }
    return nullptr;
}

FFGPU_GLX GLXContext glXCreateContextWithConfigSGIX(
    Display* dpy, GLXFBConfigSGIX config, int render_type, GLXContext share, Bool direct) {
    return glXCreateNewContext(dpy, config, render_type, share, direct);
}

// A context that is current lives on until it is not any more: its binding keeps it.
FFGPU_GLX void glXDestroyContext(Display* dpy, GLXContext context) {
    const Turn turn;
    GlxDisplay& display = GlxDisplay::of(dpy);
    if (display.contexts.erase(context) == 0 && context && glx_current().context != context)
        display.report_glx(GlxBadContext, RequestDestroyContext);
}

FFGPU_GLX Bool glXIsDirect(Display* dpy, GLXContext context) {
    const Turn turn;
    return GlxDisplay::of(dpy).contexts.contains(context);
}

FFGPU_GLX int glXQueryContext(Display* dpy, GLXContext context, int attribute, int* value) {
    const Turn turn;
    GlxDisplay& display = GlxDisplay::of(dpy);
    if (!display.contexts.contains(context)) {
        display.report_glx(GlxBadContext, RequestQueryContext);
        return GLX_BAD_CONTEXT;
    }
    switch (attribute) {
    case GLX_FBCONFIG_ID:
        *value = context->config.id;
        return 0;
    case GLX_RENDER_TYPE:
        *value = GLX_RGBA_TYPE;
        return 0;
    case GLX_SCREEN:
        *value = context->config.screen;
        return 0;
    default:
        return GLX_BAD_ATTRIBUTE;
    }
}

FFGPU_GLX void
glXCopyContext(Display* dpy, GLXContext source, GLXContext destination, unsigned long mask) {
    const Turn turn;
    GlxDisplay& display = GlxDisplay::of(dpy);
    if (!display.contexts.contains(source) || !display.contexts.contains(destination))
        return display.report_glx(GlxBadContext, RequestCopyContext);
    if (destination->bound) return display.report_core(BadAccess, RequestCopyContext);
    source->context.flush_vertices();
    AttributeStack copied;
    copied.push(source->context, static_cast<GLbitfield>(mask));
    copied.pop(destination->context);
}
