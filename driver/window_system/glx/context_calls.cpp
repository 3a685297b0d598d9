// Rendering contexts (GLX 1.4, 3.3.7; GLX_ARB_create_context).

#include "driver/window_system/glx/current.h"
#include "driver/window_system/glx/display.h"
#include "driver/window_system/glx/protocol.h"
#include "driver/window_system/refused_version.h"
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

// What glXCreateContextAttribsARB asks for.
struct ContextWish {
    int major = 1, minor = 0;
    int render_type = GLX_RGBA_TYPE;
    int flags = 0;
    int profile = GLX_CONTEXT_CORE_PROFILE_BIT_ARB;
    bool all_known = true; // attributes
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
            wish.flags = at[1];
            break;
        case GLX_CONTEXT_PROFILE_MASK_ARB:
            wish.profile = at[1];
            break;
        case GLX_RENDER_TYPE:
            wish.render_type = at[1];
            break;
        default:
            wish.all_known = false;
        }
    }
    return wish;
}

// Of OpenGL: 1.0 to 1.5, 2.0 and 2.1, 3.0 to 3.3, 4.0 to 4.6.
bool is_version(int major, int minor) {
    constexpr int LastMinor[] = {5, 1, 3, 6};
    return major >= 1 && major <= 4 && minor >= 0 && minor <= LastMinor[major - 1];
}

struct Refusal {
    bool of_glx = false; // else of the core protocol
    int error = 0;       // none
};

// GLX_ARB_create_context, GLX_ARB_create_context_profile, "Errors".
Refusal refusal(const ContextWish& wish, bool config_exists) {
    constexpr int KnownFlags = GLX_CONTEXT_DEBUG_BIT_ARB | GLX_CONTEXT_FORWARD_COMPATIBLE_BIT_ARB;
    const bool is_rgba = wish.render_type == GLX_RGBA_TYPE;
    if (!wish.all_known || (wish.flags & ~KnownFlags) != 0) return {false, BadValue};
    if (!is_rgba && wish.render_type != GLX_COLOR_INDEX_TYPE) return {false, BadValue};
    if (!config_exists) return {true, GlxBadFbConfig};
    if (wish.profile != GLX_CONTEXT_CORE_PROFILE_BIT_ARB &&
        wish.profile != GLX_CONTEXT_COMPATIBILITY_PROFILE_BIT_ARB)
        return {true, GlxBadProfile};
    // Forward compatibility began with 3.0, and ended the rendering of colour indices.
    const bool forward = (wish.flags & GLX_CONTEXT_FORWARD_COMPATIBLE_BIT_ARB) != 0;
    if (!is_version(wish.major, wish.minor) || (forward && wish.major < 3) || !is_rgba)
        return {false, BadMatch};
    if (wish.major > 1) return {true, GlxBadFbConfig};
    return {};
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
    const Refusal refused = refusal(wish, config != nullptr);
    if (config && refused.error == 0) return create(display, dpy, *config, share, Minor);
    if (wish.major > 1 && refused.of_glx) tell_refused_version(wish.major, wish.minor);
    if (refused.of_glx) {
        display.report_glx(refused.error, Minor);
    } else {
        display.report_core(refused.error, Minor);
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
