// Configurations and visuals (GLX 1.4, 3.3.1 and 3.3.3).

#include "driver/window_system/glx/choose.h"
#include "driver/window_system/glx/display.h"
#include "driver/window_system/turn.h"

#include <cstdlib>

namespace ffgpu::gl {
namespace {

// The list as the program gets it: it frees it with XFree.
GLXFBConfig* hand_out(const std::vector<const GlxConfig*>& configs, int* count) {
    *count = 0;
    if (configs.empty()) return nullptr;
    auto* const list = static_cast<GLXFBConfig*>(std::malloc(configs.size() * sizeof(GLXFBConfig)));
    if (!list) return nullptr;
    for (const GlxConfig* config : configs)
        list[(*count)++] = const_cast<GLXFBConfig>(config);
    return list;
}

GLXFBConfig* choose(Display* display, int screen, const Wishes& wishes, int* count) {
    const Turn turn;
    GlxScreen* const on = GlxDisplay::of(display).screen(screen);
    if (!on) return nullptr;
    return hand_out(choose_configs(on->configs, wishes), count);
}

} // namespace
} // namespace ffgpu::gl

using namespace ffgpu::gl;

FFGPU_GLX GLXFBConfig*
glXChooseFBConfig(Display* dpy, int screen, const int* attribList, int* nitems) {
    *nitems = 0;
    const auto wishes = read_config_wishes(attribList);
    return wishes ? choose(dpy, screen, *wishes, nitems) : nullptr;
}

FFGPU_GLX GLXFBConfig* glXGetFBConfigs(Display* dpy, int screen, int* nelements) {
    *nelements = 0;
    return choose(dpy, screen, {}, nelements);
}

FFGPU_GLX int glXGetFBConfigAttrib(Display* dpy, GLXFBConfig config, int attribute, int* value) {
    const Turn turn;
    const GlxConfig* const known = GlxDisplay::of(dpy).config_of(config);
    if (!known) return GLX_NO_EXTENSION;
    const auto found = config_attribute(*known, attribute);
    if (!found) return GLX_BAD_ATTRIBUTE;
    *value = *found;
    return 0;
}

FFGPU_GLX XVisualInfo* glXGetVisualFromFBConfig(Display* dpy, GLXFBConfig config) {
    const Turn turn;
    GlxDisplay& display = GlxDisplay::of(dpy);
    const GlxConfig* const known = display.config_of(config);
    return known ? display.hand_out_visual(*known) : nullptr;
}

FFGPU_GLX XVisualInfo* glXChooseVisual(Display* dpy, int screen, int* attribList) {
    const Turn turn;
    GlxDisplay& display = GlxDisplay::of(dpy);
    GlxScreen* const on = display.screen(screen);
    const auto wishes = read_visual_wishes(attribList);
    if (!on || !wishes) return nullptr;
    const auto found = choose_configs(on->configs, *wishes);
    if (found.empty()) return nullptr;
    return display.hand_out_visual(*found.front());
}

FFGPU_GLX int glXGetConfig(Display* dpy, XVisualInfo* visual, int attribute, int* value) {
    const Turn turn;
    GlxDisplay& display = GlxDisplay::of(dpy);
    if (!display.screen(visual->screen)) return GLX_BAD_SCREEN;
    const GlxConfig* const config = display.config_of(*visual);
    if (attribute == GLX_USE_GL) {
        *value = config != nullptr;
        return 0;
    }
    if (!config) return GLX_BAD_VISUAL;
    const auto found = config_attribute(*config, attribute);
    if (!found) return GLX_BAD_ATTRIBUTE;
    *value = *found;
    return 0;
}

FFGPU_GLX GLXFBConfig* glXChooseFBConfigSGIX(Display* dpy, int screen, int* list, int* nelements) {
    return glXChooseFBConfig(dpy, screen, list, nelements);
}

FFGPU_GLX int
glXGetFBConfigAttribSGIX(Display* dpy, GLXFBConfigSGIX config, int attribute, int* value) {
    return glXGetFBConfigAttrib(dpy, config, attribute, value);
}

FFGPU_GLX XVisualInfo* glXGetVisualFromFBConfigSGIX(Display* dpy, GLXFBConfigSGIX config) {
    return glXGetVisualFromFBConfig(dpy, config);
}

FFGPU_GLX GLXFBConfigSGIX glXGetFBConfigFromVisualSGIX(Display* dpy, XVisualInfo* visual) {
    const Turn turn;
    return const_cast<GLXFBConfig>(GlxDisplay::of(dpy).config_of(*visual));
}
