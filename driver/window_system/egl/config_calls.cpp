// Configurations (EGL 1.5, 3.4).

#include "driver/window_system/egl/thread_state.h"

#include <algorithm>

namespace ffgpu::gl {
namespace {

// As many as the program has room for; without room only their number.
void hand_out(const std::vector<const EglConfig*>& list,
              EGLConfig* configs,
              EGLint size,
              EGLint* count) {
    if (!count) throw EglError{EGL_BAD_PARAMETER};
    const auto known = static_cast<EGLint>(list.size());
    if (!configs) {
        *count = known;
        return;
    }
    *count = std::clamp(size, 0, known);
    for (EGLint i = 0; i < *count; ++i)
        configs[i] = const_cast<EglConfig*>(list[static_cast<std::size_t>(i)]);
}

} // namespace
} // namespace ffgpu::gl

using namespace ffgpu::gl;

FFGPU_EGL EGLBoolean eglGetConfigs(EGLDisplay dpy,
                                   EGLConfig* configs,
                                   EGLint config_size,
                                   EGLint* num_config) {
    return egl_call<EGLBoolean>(EGL_FALSE, [&] {
        std::vector<const EglConfig*> all;
        for (const EglConfig& config : require_display(dpy).configs())
            all.push_back(&config);
        hand_out(all, configs, config_size, num_config);
        return EGL_TRUE;
    });
}

FFGPU_EGL EGLBoolean eglChooseConfig(EGLDisplay dpy,
                                     const EGLint* attributes,
                                     EGLConfig* configs,
                                     EGLint config_size,
                                     EGLint* num_config) {
    return egl_call<EGLBoolean>(EGL_FALSE, [&] {
        const auto chosen = choose_egl_configs(require_display(dpy).configs(), attributes);
        if (!chosen) throw EglError{EGL_BAD_ATTRIBUTE};
        hand_out(*chosen, configs, config_size, num_config);
        return EGL_TRUE;
    });
}

FFGPU_EGL EGLBoolean eglGetConfigAttrib(EGLDisplay dpy,
                                        EGLConfig config,
                                        EGLint attribute,
                                        EGLint* value) {
    return egl_call<EGLBoolean>(EGL_FALSE, [&] {
        const EglDisplay& display = require_display(dpy);
        const auto found = egl_config_attribute(require_config(display, config), attribute);
        if (!found) throw EglError{EGL_BAD_ATTRIBUTE};
        *value = *found;
        return EGL_TRUE;
    });
}
