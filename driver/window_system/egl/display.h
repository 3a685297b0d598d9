// EglDisplay: what stands behind an EGLDisplay: an X server, or none (then there are only pbuffers
// and contexts without a surface).

#pragma once

#include "driver/window_system/binding/binding.h"
#include "driver/window_system/binding/formats.h"
#include "driver/window_system/egl/configs.h"

#include <map>
#include <memory>
#include <vector>

namespace ffgpu::gl {

enum class EglPlatform { X11, Surfaceless };

struct EglContext : RenderContext {
    EglContext(const EglConfig* of, const RenderContext* share)
        : RenderContext(share)
        , config_id(of ? of->id : 0) {}

    int config_id; // 0: made without one
};

struct EglSurface {
    std::shared_ptr<WindowSurface> surface;
    EGLint type = EGL_PBUFFER_BIT; // or EGL_WINDOW_BIT, EGL_PIXMAP_BIT
    bool largest_pbuffer = false;
    EGLint swap_behavior =
        swap_mode() == SwapMode::Copy ? EGL_BUFFER_PRESERVED : EGL_BUFFER_DESTROYED;
};

class EglDisplay {
public:
    EglDisplay(EglPlatform platform, Display* native)
        : platform_(platform)
        , native_(native) {}

    // In a Turn, as all below. The display for a platform's own (null: the default), always the
    // same one.
    static EglDisplay* get(EglPlatform platform, Display* native);
    // Null: the handle is none.
    static EglDisplay* from(EGLDisplay handle);

    // False: there is no such X server.
    bool initialize();
    void terminate();
    bool initialized() const { return initialized_; }

    EglPlatform platform() const { return platform_; }
    Display* native() const { return native_; }
    const std::vector<EglConfig>& configs() const { return configs_; }
    // Null: the handle is none of this display's.
    const EglConfig* config(EGLConfig handle) const;
    std::shared_ptr<EglContext> context(EGLContext handle) const;
    EglSurface* surface(EGLSurface handle);

    std::map<EGLContext, std::shared_ptr<EglContext>> contexts;
    std::map<EGLSurface, std::unique_ptr<EglSurface>> surfaces;
    std::map<EGLSync, EGLenum> syncs; // and their types

private:
    static void closed(Display* native);

    EglPlatform platform_;
    Display* native_; // Null: the default, until initialize() has connected.
    bool initialized_ = false;
    std::vector<EglConfig> configs_;
};

} // namespace ffgpu::gl
