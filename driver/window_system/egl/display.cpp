#include "driver/window_system/egl/display.h"

#include "driver/window_system/turn.h"
#include "driver/window_system/x11/internals.h"

#include <algorithm>

namespace ffgpu::gl {
namespace {

using Displays =
    std::vector<std::pair<std::pair<EglPlatform, Display*>, std::unique_ptr<EglDisplay>>>;

// Handles stay valid until the process ends (EGL 1.5, 3.2).
Displays& displays() {
    static auto* const all = new Displays;
    return *all;
}

} // namespace

EglDisplay* EglDisplay::get(EglPlatform platform, Display* native) {
    const std::pair key(platform, native);
    for (const auto& [known, display] : displays())
        if (known == key) return display.get();
    displays().emplace_back(key, std::make_unique<EglDisplay>(platform, native));
    return displays().back().second.get();
}

EglDisplay* EglDisplay::from(EGLDisplay handle) {
    for (const auto& [known, display] : displays())
        if (display.get() == handle) return display.get();
    return nullptr;
}

bool EglDisplay::initialize() {
    if (initialized_) return true;
    unsigned long visual = 0;
    if (platform_ == EglPlatform::X11) {
        if (!native_) native_ = XOpenDisplay(nullptr);
        if (!native_) return false;
        visual = XVisualIDFromVisual(DefaultVisual(native_, DefaultScreen(native_)));
        on_close(native_, closed);
    }
    configs_ = make_egl_configs(visual);
    return initialized_ = true;
}

// What is current somewhere lives on until it is not any more (EGL 1.5, 3.2).
void EglDisplay::terminate() {
    contexts.clear();
    surfaces.clear();
    syncs.clear();
    initialized_ = false;
}

void EglDisplay::closed(Display* native) {
    const Turn turn;
    for (const auto& [known, display] : displays()) {
        if (display->native_ != native) continue;
        for (const auto& [handle, surface] : display->surfaces)
            if (XTarget* const target = surface->surface->target()) target->abandon();
        display->terminate();
        display->native_ = known.second;
    }
}

const EglConfig* EglDisplay::config(EGLConfig handle) const {
    for (const EglConfig& config : configs_)
        if (&config == handle) return &config;
    return nullptr;
}

std::shared_ptr<EglContext> EglDisplay::context(EGLContext handle) const {
    const auto found = contexts.find(handle);
    return found == contexts.end() ? nullptr : found->second;
}

EglSurface* EglDisplay::surface(EGLSurface handle) {
    const auto found = surfaces.find(handle);
    return found == surfaces.end() ? nullptr : found->second.get();
}

} // namespace ffgpu::gl
