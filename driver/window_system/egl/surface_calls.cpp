// Windows, pbuffers and pixmaps (EGL 1.5, 3.5), and the posting of their pictures (3.10).

#include "driver/window_system/egl/thread_state.h"
#include "model/device/layout/limits.h"

#include <algorithm>
#include <vector>

namespace ffgpu::gl {
namespace {

EGLSurface add(EglDisplay& display, std::unique_ptr<EglSurface> made, const EglConfig& config) {
    made->surface->config_id = config.id;
    const EGLSurface handle = made.get();
    display.surfaces.emplace(handle, std::move(made));
    return handle;
}

// Attributes come as EGLint or as EGLAttrib.
template <class Value>
EGLint attribute_of(const Value* list, EGLint name, EGLint otherwise) {
    for (const Value* at = list; at && at[0] != EGL_NONE; at += 2)
        if (at[0] == name) return static_cast<EGLint>(at[1]);
    return otherwise;
}

template <class Value>
EGLSurface
wrap(EGLDisplay dpy, EGLConfig handle, XID native, EGLint type, const Value* attributes) {
    EglDisplay& display = require_display(dpy);
    const EglConfig& config = require_config(display, handle);
    const EGLint bad_native =
        type == EGL_WINDOW_BIT ? EGL_BAD_NATIVE_WINDOW : EGL_BAD_NATIVE_PIXMAP;
    if (!display.native()) throw EglError{bad_native};
    for (const auto& [known, other] : display.surfaces) {
        XTarget* const target = other->surface->target();
        if (type == EGL_WINDOW_BIT && target && target->drawable() == native)
            throw EglError{EGL_BAD_ALLOC}; // A window has one surface.
    }
    auto target = std::make_unique<XTarget>(display.native(), native);
    if (!target->size()) throw EglError{bad_native};
    PixelFormat format = config.format;
    const EGLint buffer = attribute_of(attributes, EGL_RENDER_BUFFER, EGL_BACK_BUFFER);
    format.double_buffer = type == EGL_WINDOW_BIT && buffer == EGL_BACK_BUFFER;
    auto made = std::make_unique<EglSurface>();
    made->surface = std::make_shared<WindowSurface>(format, std::move(target));
    made->type = type;
    return add(display, std::move(made), config);
}

EGLSurface make_pbuffer(EGLDisplay dpy, EGLConfig handle, const EGLint* attributes) {
    EglDisplay& display = require_display(dpy);
    const EglConfig& config = require_config(display, handle);
    const EGLint width = attribute_of(attributes, EGL_WIDTH, 0);
    const EGLint height = attribute_of(attributes, EGL_HEIGHT, 0);
    const bool largest = attribute_of(attributes, EGL_LARGEST_PBUFFER, EGL_FALSE) != EGL_FALSE;
    constexpr EGLint Limit = ffgpu::MaxSurfaceSize;
    if (width < 0 || height < 0) throw EglError{EGL_BAD_PARAMETER};
    if (!largest && (width > Limit || height > Limit)) throw EglError{EGL_BAD_ALLOC};
    if (attribute_of(attributes, EGL_TEXTURE_FORMAT, EGL_NO_TEXTURE) != EGL_NO_TEXTURE)
        throw EglError{EGL_BAD_MATCH}; // That is OpenGL ES.
    auto made = std::make_unique<EglSurface>();
    made->surface =
        std::make_shared<WindowSurface>(config.format,
                                        Size{static_cast<unsigned>(std::min(width, Limit)),
                                             static_cast<unsigned>(std::min(height, Limit))});
    made->largest_pbuffer = largest;
    return add(display, std::move(made), config);
}

EGLint query(EglSurface& surface, EGLint attribute) {
    switch (attribute) {
    case EGL_WIDTH:
        return static_cast<EGLint>(surface.surface->size().width);
    case EGL_HEIGHT:
        return static_cast<EGLint>(surface.surface->size().height);
    case EGL_CONFIG_ID:
        return surface.surface->config_id;
    case EGL_RENDER_BUFFER:
        return surface.surface->format().double_buffer ? EGL_BACK_BUFFER : EGL_SINGLE_BUFFER;
    case EGL_SWAP_BEHAVIOR:
        return surface.swap_behavior;
    case EGL_LARGEST_PBUFFER:
        return surface.largest_pbuffer;
    case EGL_HORIZONTAL_RESOLUTION:
    case EGL_VERTICAL_RESOLUTION:
    case EGL_PIXEL_ASPECT_RATIO:
        return EGL_UNKNOWN;
    case EGL_MULTISAMPLE_RESOLVE:
        return EGL_MULTISAMPLE_RESOLVE_DEFAULT;
    case EGL_GL_COLORSPACE:
        return EGL_GL_COLORSPACE_LINEAR;
    case EGL_VG_ALPHA_FORMAT:
        return EGL_VG_ALPHA_FORMAT_NONPRE;
    case EGL_VG_COLORSPACE:
        return EGL_VG_COLORSPACE_sRGB;
    case EGL_TEXTURE_FORMAT:
    case EGL_TEXTURE_TARGET:
        return EGL_NO_TEXTURE;
    case EGL_MIPMAP_TEXTURE:
    case EGL_MIPMAP_LEVEL:
        return 0;
    default:
        throw EglError{EGL_BAD_ATTRIBUTE};
    }
}

} // namespace
} // namespace ffgpu::gl

using namespace ffgpu::gl;

FFGPU_EGL EGLSurface eglCreateWindowSurface(EGLDisplay dpy,
                                            EGLConfig config,
                                            EGLNativeWindowType window,
                                            const EGLint* attributes) {
    return egl_call(EGL_NO_SURFACE, [&] {
        return wrap(dpy, config, static_cast<XID>(window), EGL_WINDOW_BIT, attributes);
    });
}

// The platform's calls take a pointer to the X window (EGL_EXT_platform_x11).
FFGPU_EGL EGLSurface eglCreatePlatformWindowSurface(EGLDisplay dpy,
                                                    EGLConfig config,
                                                    void* window,
                                                    const EGLAttrib* attributes) {
    return egl_call(EGL_NO_SURFACE, [&] {
        if (!window) throw EglError{EGL_BAD_NATIVE_WINDOW};
        return wrap(dpy, config, *static_cast<XID*>(window), EGL_WINDOW_BIT, attributes);
    });
}

FFGPU_EGL EGLSurface eglCreatePlatformWindowSurfaceEXT(EGLDisplay dpy,
                                                       EGLConfig config,
                                                       void* window,
                                                       const EGLint* attributes) {
    return egl_call(EGL_NO_SURFACE, [&] {
        if (!window) throw EglError{EGL_BAD_NATIVE_WINDOW};
        return wrap(dpy, config, *static_cast<XID*>(window), EGL_WINDOW_BIT, attributes);
    });
}

FFGPU_EGL EGLSurface eglCreatePixmapSurface(EGLDisplay dpy,
                                            EGLConfig config,
                                            EGLNativePixmapType pixmap,
                                            const EGLint* attributes) {
    return egl_call(EGL_NO_SURFACE, [&] {
        return wrap(dpy, config, static_cast<XID>(pixmap), EGL_PIXMAP_BIT, attributes);
    });
}

FFGPU_EGL EGLSurface eglCreatePlatformPixmapSurface(EGLDisplay dpy,
                                                    EGLConfig config,
                                                    void* pixmap,
                                                    const EGLAttrib* attributes) {
    return egl_call(EGL_NO_SURFACE, [&] {
        if (!pixmap) throw EglError{EGL_BAD_NATIVE_PIXMAP};
        return wrap(dpy, config, *static_cast<XID*>(pixmap), EGL_PIXMAP_BIT, attributes);
    });
}

FFGPU_EGL EGLSurface eglCreatePlatformPixmapSurfaceEXT(EGLDisplay dpy,
                                                       EGLConfig config,
                                                       void* pixmap,
                                                       const EGLint* attributes) {
    return egl_call(EGL_NO_SURFACE, [&] {
        if (!pixmap) throw EglError{EGL_BAD_NATIVE_PIXMAP};
        return wrap(dpy, config, *static_cast<XID*>(pixmap), EGL_PIXMAP_BIT, attributes);
    });
}

FFGPU_EGL EGLSurface eglCreatePbufferSurface(EGLDisplay dpy,
                                             EGLConfig config,
                                             const EGLint* attributes) {
    return egl_call(EGL_NO_SURFACE, [&] { return make_pbuffer(dpy, config, attributes); });
}

FFGPU_EGL EGLSurface eglCreatePbufferFromClientBuffer(
    EGLDisplay dpy, EGLenum, EGLClientBuffer, EGLConfig, const EGLint*) {
    return egl_call(EGL_NO_SURFACE, [&]() -> EGLSurface {
        require_display(dpy);
        throw EglError{EGL_BAD_PARAMETER}; // Client buffers are OpenVG's.
    });
}

FFGPU_EGL EGLBoolean eglDestroySurface(EGLDisplay dpy, EGLSurface surface) {
    return egl_call<EGLBoolean>(EGL_FALSE, [&] {
        EglDisplay& display = require_display(dpy);
        require_surface(display, surface);
        display.surfaces.erase(surface); // A thread that has it current keeps it.
        return EGL_TRUE;
    });
}

FFGPU_EGL EGLBoolean eglQuerySurface(EGLDisplay dpy,
                                     EGLSurface surface,
                                     EGLint attribute,
                                     EGLint* value) {
    return egl_call<EGLBoolean>(EGL_FALSE, [&] {
        EglSurface& known = require_surface(require_display(dpy), surface);
        if (!known.surface->bound || attribute == EGL_WIDTH || attribute == EGL_HEIGHT)
            known.surface->follow_window();
        *value = query(known, attribute);
        return EGL_TRUE;
    });
}

FFGPU_EGL EGLBoolean eglSurfaceAttrib(EGLDisplay dpy,
                                      EGLSurface surface,
                                      EGLint attribute,
                                      EGLint value) {
    return egl_call<EGLBoolean>(EGL_FALSE, [&] {
        EglSurface& known = require_surface(require_display(dpy), surface);
        if (attribute == EGL_SWAP_BEHAVIOR) {
            const bool preserved = value == EGL_BUFFER_PRESERVED;
            if (!preserved && value != EGL_BUFFER_DESTROYED) throw EglError{EGL_BAD_PARAMETER};
            // No configuration then has EGL_SWAP_BEHAVIOR_PRESERVED_BIT.
            if (preserved && swap_mode() != SwapMode::Copy) throw EglError{EGL_BAD_MATCH};
            known.swap_behavior = value;
        }
        if (attribute != EGL_SWAP_BEHAVIOR && attribute != EGL_MULTISAMPLE_RESOLVE &&
            attribute != EGL_MIPMAP_LEVEL)
            throw EglError{EGL_BAD_ATTRIBUTE};
        return EGL_TRUE;
    });
}

FFGPU_EGL EGLBoolean eglSwapBuffers(EGLDisplay dpy, EGLSurface surface) {
    return egl_call<EGLBoolean>(EGL_FALSE, [&] {
        EglSurface& known = require_surface(require_display(dpy), surface);
        if (known.type == EGL_WINDOW_BIT) {
            swap_surface(*known.surface);
        } else {
            flush_current(); // All that a swap does to pixmaps and pbuffers (EGL 1.5, 3.10.1).
        }
        return EGL_TRUE;
    });
}

// There is no refresh to wait for.
FFGPU_EGL EGLBoolean eglSwapInterval(EGLDisplay dpy, EGLint) {
    return egl_call<EGLBoolean>(EGL_FALSE, [&] {
        require_display(dpy);
        if (!egl_thread().is_current()) throw EglError{EGL_BAD_CONTEXT};
        if (!egl_thread().draw) throw EglError{EGL_BAD_SURFACE};
        return EGL_TRUE;
    });
}

FFGPU_EGL EGLBoolean eglCopyBuffers(EGLDisplay dpy,
                                    EGLSurface surface,
                                    EGLNativePixmapType pixmap) {
    return egl_call<EGLBoolean>(EGL_FALSE, [&] {
        EglDisplay& display = require_display(dpy);
        EglSurface& known = require_surface(display, surface);
        if (!display.native()) throw EglError{EGL_BAD_NATIVE_PIXMAP};
        XTarget target(display.native(), static_cast<XID>(pixmap));
        const auto size = target.size();
        if (!size) throw EglError{EGL_BAD_NATIVE_PIXMAP};
        flush_current();
        target.show(known.surface->drawable().readable_back(),
                    *size,
                    [](ffgpu::DeviceAddress at, std::span<std::byte> bytes) {
                        ProcessGpu::instance().device().read_memory(at, bytes);
                    });
        return EGL_TRUE;
    });
}

// Pictures of surfaces as textures are OpenGL ES's alone.
FFGPU_EGL EGLBoolean eglBindTexImage(EGLDisplay dpy, EGLSurface surface, EGLint) {
    return egl_call<EGLBoolean>(EGL_FALSE, [&]() -> EGLBoolean {
        require_surface(require_display(dpy), surface);
        throw EglError{EGL_BAD_MATCH};
    });
}

FFGPU_EGL EGLBoolean eglReleaseTexImage(EGLDisplay dpy, EGLSurface surface, EGLint buffer) {
    return eglBindTexImage(dpy, surface, buffer);
}
