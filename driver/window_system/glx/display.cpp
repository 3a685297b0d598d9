#include "driver/window_system/glx/display.h"

#include "driver/window_system/turn.h"
#include "driver/window_system/x11/internals.h"

#include <algorithm>

namespace ffgpu::gl {
namespace {

std::map<Display*, std::unique_ptr<GlxDisplay>>& displays() {
    static auto* const all = new std::map<Display*, std::unique_ptr<GlxDisplay>>;
    return *all;
}

void forget_display(Display* display) {
    const Turn turn;
    displays().erase(display);
}

std::vector<XVisualInfo> true_color_visuals(Display* display, int screen) {
    XVisualInfo wanted{};
    wanted.screen = screen;
    wanted.depth = DefaultDepth(display, screen);
    wanted.c_class = TrueColor;
    int count = 0;
    XVisualInfo* const found = XGetVisualInfo(
        display, VisualScreenMask | VisualDepthMask | VisualClassMask, &wanted, &count);
    std::vector<XVisualInfo> visuals(found, found + count);
    if (found) XFree(found);
    // The default visual first: windows of it share the root's colour map.
    const VisualID usual = XVisualIDFromVisual(DefaultVisual(display, screen));
    const auto is_usual = [&](const XVisualInfo& visual) { return visual.visualid == usual; };
    std::stable_partition(visuals.begin(), visuals.end(), is_usual);
    return visuals;
}

} // namespace

GlxDisplay& GlxDisplay::of(Display* display) {
    std::unique_ptr<GlxDisplay>& known = displays()[display];
    if (!known) known = std::make_unique<GlxDisplay>(display);
    return *known;
}

GlxDisplay::GlxDisplay(Display* display)
    : display_(display) {
    for (int number = 0; number < ScreenCount(display); ++number) {
        GlxScreen screen;
        screen.visuals = true_color_visuals(display, number);
        screen.configs = make_configs(number, screen.visuals);
        screens_.push_back(std::move(screen));
    }
    XQueryExtension(display, "GLX", &major_opcode_, &event_base_, &error_base_);
    on_close(display, forget_display);
}

GlxDisplay::~GlxDisplay() {
    for (auto& [id, drawable] : drawables)
        if (XTarget* const target = drawable.surface->target()) target->abandon();
}

GlxScreen* GlxDisplay::screen(int number) {
    const bool exists = number >= 0 && static_cast<std::size_t>(number) < screens_.size();
    return exists ? &screens_[static_cast<std::size_t>(number)] : nullptr;
}

const GlxConfig* GlxDisplay::config_of(const XVisualInfo& visual) {
    GlxScreen* const on = screen(visual.screen);
    if (!on) return nullptr;
    if (const auto chosen = on->chosen.find(visual.visualid); chosen != on->chosen.end()) {
        const auto config = std::ranges::find(on->configs, chosen->second, &GlxConfig::id);
        if (config != on->configs.end()) return &*config;
    }
    const auto config = std::ranges::find(on->configs, visual.visualid, &GlxConfig::visual);
    return config == on->configs.end() ? nullptr : &*config;
}

const GlxConfig* GlxDisplay::config_of(GLXFBConfig handle) {
    for (const GlxScreen& on : screens_)
        for (const GlxConfig& config : on.configs)
            if (&config == handle) return handle;
    return nullptr;
}

XVisualInfo* GlxDisplay::hand_out_visual(const GlxConfig& config) {
    if (GlxScreen* const on = screen(config.screen)) on->chosen[config.visual] = config.id;
    XVisualInfo wanted{};
    wanted.visualid = config.visual;
    wanted.screen = config.screen;
    int count = 0;
    return XGetVisualInfo(display_, VisualIDMask | VisualScreenMask, &wanted, &count);
}

void GlxDisplay::report_glx(int code, unsigned minor, XID resource) {
    report(error_base_ + code, minor, resource);
}

void GlxDisplay::report_core(int code, unsigned minor, XID resource) {
    report(code, minor, resource);
}

void GlxDisplay::report(int code, unsigned minor, XID resource) {
    send_error(display_, {code, major_opcode_, minor, resource});
}

void GlxDisplay::sweep() {
    std::erase_if(drawables, [](const auto& entry) {
        const GlxDrawable& drawable = entry.second;
        if (drawable.kind != GlxDrawable::Kind::Window || drawable.surface->bound) return false;
        return !drawable.surface->target()->size();
    });
}

} // namespace ffgpu::gl
