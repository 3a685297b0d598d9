#include "driver/window_system/glx/configs.h"

#include "driver/window_system/binding/formats.h"
#include "model/device/layout/limits.h"

#include <algorithm>

namespace ffgpu::gl {
namespace {

constexpr int FirstId = 0x101;

} // namespace

std::vector<GlxConfig> make_configs(int screen, const std::vector<XVisualInfo>& visuals) {
    std::vector<GlxConfig> configs;
    if (visuals.empty()) return configs;
    int id = FirstId;
    for (const PixelFormat& format : offered_formats(true)) {
        const std::size_t nth = std::min(configs.size(), visuals.size() - 1);
        configs.push_back({format, id++, screen, visuals[nth].visualid});
    }
    return configs;
}

std::optional<int> config_attribute(const GlxConfig& config, int attribute) {
    const PixelFormat& format = config.format;
    const int alpha = format.alpha ? ColorBits : 0;
    const int accumulation = format.accumulation ? AccumulationBits : 0;
    switch (attribute) {
    case GLX_FBCONFIG_ID:
        return config.id;
    case GLX_VISUAL_ID:
        return static_cast<int>(config.visual);
    case GLX_SCREEN:
        return config.screen;
    case GLX_BUFFER_SIZE:
        return 3 * ColorBits + alpha;
    case GLX_RED_SIZE:
    case GLX_GREEN_SIZE:
    case GLX_BLUE_SIZE:
        return ColorBits;
    case GLX_ALPHA_SIZE:
        return alpha;
    case GLX_DEPTH_SIZE:
        return format.depth_bits;
    case GLX_STENCIL_SIZE:
        return format.stencil_bits;
    case GLX_ACCUM_RED_SIZE:
    case GLX_ACCUM_GREEN_SIZE:
    case GLX_ACCUM_BLUE_SIZE:
        return accumulation;
    case GLX_ACCUM_ALPHA_SIZE:
        return format.alpha ? accumulation : 0;
    case GLX_SAMPLE_BUFFERS:
        return format.samples > 1;
    case GLX_SAMPLES:
        return format.samples > 1 ? format.samples : 0;
    case GLX_DOUBLEBUFFER:
        return format.double_buffer;
    case GLX_FRAMEBUFFER_SRGB_CAPABLE_ARB:
    case GLX_RGBA:
    case GLX_USE_GL:
    case GLX_X_RENDERABLE:
        return True;
    case GLX_RENDER_TYPE:
        return GLX_RGBA_BIT;
    case GLX_DRAWABLE_TYPE:
        return GLX_WINDOW_BIT | GLX_PIXMAP_BIT | GLX_PBUFFER_BIT;
    case GLX_X_VISUAL_TYPE:
        return GLX_TRUE_COLOR;
    case GLX_CONFIG_CAVEAT:
    case GLX_TRANSPARENT_TYPE:
        return GLX_NONE;
    case GLX_MAX_PBUFFER_WIDTH:
    case GLX_MAX_PBUFFER_HEIGHT:
        return MaxSurfaceSize;
    case GLX_MAX_PBUFFER_PIXELS:
        return MaxSurfaceSize * MaxSurfaceSize;
    case GLX_SWAP_METHOD_OML:
        return !format.double_buffer           ? GLX_SWAP_UNDEFINED_OML
               : swap_mode() == SwapMode::Copy ? GLX_SWAP_COPY_OML
                                               : GLX_SWAP_EXCHANGE_OML;
    case GLX_LEVEL:
    case GLX_STEREO:
    case GLX_AUX_BUFFERS:
    case GLX_TRANSPARENT_INDEX_VALUE:
    case GLX_TRANSPARENT_RED_VALUE:
    case GLX_TRANSPARENT_GREEN_VALUE:
    case GLX_TRANSPARENT_BLUE_VALUE:
    case GLX_TRANSPARENT_ALPHA_VALUE:
    case GLX_OPTIMAL_PBUFFER_WIDTH_SGIX:
    case GLX_OPTIMAL_PBUFFER_HEIGHT_SGIX:
        return 0;
    default:
        return std::nullopt;
    }
}

} // namespace ffgpu::gl
