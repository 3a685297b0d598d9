// EGL's configurations: attributes, selection and order (EGL 1.5, 3.4).

#pragma once

#include "driver/framebuffer/drawable.h"
#include "driver/window_system/egl/egl.h"

#include <map>
#include <optional>
#include <vector>

namespace ffgpu::gl {

// Whether a surface has a back buffer is the surface's affair in EGL.
struct EglConfig {
    PixelFormat format;
    int id = 0;
    unsigned long visual = 0; // of windows on X; 0: there are none
};

// `visual`: what windows of the screen have, or 0.
std::vector<EglConfig> make_egl_configs(unsigned long visual);

// An attribute's value as eglGetConfigAttrib tells it. Nothing: no such attribute.
std::optional<EGLint> egl_config_attribute(const EglConfig& config, EGLint attribute);

// The configurations that have all that is asked for, the best first. Nothing: the list names an
// unknown attribute or a value that it cannot have.
std::optional<std::vector<const EglConfig*>>
choose_egl_configs(const std::vector<EglConfig>& configs, const EGLint* attributes);

} // namespace ffgpu::gl
