// Framebuffer configurations of a screen and the X visuals they go with.

#pragma once

#include "driver/framebuffer/drawable.h"
#include "driver/window_system/glx/glx.h"

#include <optional>
#include <vector>

// The type behind GLXFBConfig.
struct __GLXFBConfigRec {
    ffgpu::gl::PixelFormat format;
    int id = 0;
    int screen = 0;
    VisualID visual = 0;
};

namespace ffgpu::gl {

using GlxConfig = __GLXFBConfigRec;

// One configuration for each pixel format, with a visual of the screen's depth. As long as visuals
// last each has one of its own, so that a program which goes by visuals finds all of them.
std::vector<GlxConfig> make_configs(int screen, const std::vector<XVisualInfo>& visuals);

// An attribute's value as glXGetFBConfigAttrib tells it. Nothing: no such attribute.
std::optional<int> config_attribute(const GlxConfig& config, int attribute);

} // namespace ffgpu::gl
