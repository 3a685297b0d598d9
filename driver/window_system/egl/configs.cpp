#include "driver/window_system/egl/configs.h"

#include "driver/window_system/binding/formats.h"
#include "model/device/layout/limits.h"

#include <algorithm>
#include <array>

namespace ffgpu::gl {
namespace {

using Wishes = std::map<EGLint, EGLint>;

bool is_bit_mask(EGLint attribute) {
    return attribute == EGL_SURFACE_TYPE || attribute == EGL_RENDERABLE_TYPE ||
           attribute == EGL_CONFORMANT;
}

bool is_minimum(EGLint attribute) {
    switch (attribute) {
    case EGL_BUFFER_SIZE:
    case EGL_RED_SIZE:
    case EGL_GREEN_SIZE:
    case EGL_BLUE_SIZE:
    case EGL_ALPHA_SIZE:
    case EGL_LUMINANCE_SIZE:
    case EGL_ALPHA_MASK_SIZE:
    case EGL_DEPTH_SIZE:
    case EGL_STENCIL_SIZE:
    case EGL_SAMPLE_BUFFERS:
    case EGL_SAMPLES:
        return true;
    default:
        return false;
    }
}

// Table 3.4 of EGL 1.5 lists them as ignored when configurations are chosen.
bool is_ignored(EGLint attribute) {
    return attribute == EGL_MAX_PBUFFER_WIDTH || attribute == EGL_MAX_PBUFFER_HEIGHT ||
           attribute == EGL_MAX_PBUFFER_PIXELS || attribute == EGL_NATIVE_VISUAL_ID;
}

bool matches(const EglConfig& config, EGLint attribute, EGLint wish) {
    // A pixmap to match: each configuration goes with pixmaps of any TrueColor depth.
    if (attribute == EGL_MATCH_NATIVE_PIXMAP) return true;
    if (wish == EGL_DONT_CARE || is_ignored(attribute)) return true;
    const EGLint value = egl_config_attribute(config, attribute).value_or(0);
    // OpenGL ES 1 is the default of the list, and programs of desktop OpenGL leave or write it
    // there: every other EGL has both. Whether it is there shows in eglBindAPI.
    if (attribute == EGL_RENDERABLE_TYPE) wish &= ~EGL_OPENGL_ES_BIT;
    if (is_bit_mask(attribute)) return (value & wish) == wish;
    return is_minimum(attribute) ? value >= wish : value == wish;
}

bool matches_all(const EglConfig& config, const Wishes& wishes) {
    // With an identity nothing else counts (EGL 1.5, 3.4.1.1).
    if (const auto id = wishes.find(EGL_CONFIG_ID);
        id != wishes.end() && id->second != EGL_DONT_CARE)
        return config.id == id->second;
    return std::ranges::all_of(
        wishes, [&](const auto& wish) { return matches(config, wish.first, wish.second); });
}

// Of two configurations the one with the lesser key comes first (EGL 1.5, 3.4.1.2).
std::array<EGLint, 6> sort_key(const EglConfig& config, const Wishes& wishes) {
    EGLint wished_bits = 0;
    for (const EGLint size : {EGL_RED_SIZE, EGL_GREEN_SIZE, EGL_BLUE_SIZE, EGL_ALPHA_SIZE}) {
        const auto wish = wishes.find(size);
        if (wish != wishes.end() && wish->second > 0)
            wished_bits += *egl_config_attribute(config, size);
    }
    return {-wished_bits,
            *egl_config_attribute(config, EGL_BUFFER_SIZE),
            config.format.samples,
            config.format.depth_bits,
            config.format.stencil_bits,
            config.id};
}

} // namespace

std::vector<EglConfig> make_egl_configs(unsigned long visual) {
    std::vector<EglConfig> configs;
    int id = 1;
    for (const PixelFormat& format : offered_formats(false))
        if (format.double_buffer) configs.push_back({format, id++, visual});
    return configs;
}

std::optional<EGLint> egl_config_attribute(const EglConfig& config, EGLint attribute) {
    const PixelFormat& format = config.format;
    const EGLint alpha = format.alpha ? ColorBits : 0;
    switch (attribute) {
    case EGL_CONFIG_ID:
        return config.id;
    case EGL_BUFFER_SIZE:
        return 3 * ColorBits + alpha;
    case EGL_RED_SIZE:
    case EGL_GREEN_SIZE:
    case EGL_BLUE_SIZE:
        return ColorBits;
    case EGL_ALPHA_SIZE:
        return alpha;
    case EGL_DEPTH_SIZE:
        return format.depth_bits;
    case EGL_STENCIL_SIZE:
        return format.stencil_bits;
    case EGL_SAMPLE_BUFFERS:
        return format.samples > 1;
    case EGL_SAMPLES:
        return format.samples > 1 ? format.samples : 0;
    case EGL_COLOR_BUFFER_TYPE:
        return EGL_RGB_BUFFER;
    case EGL_CONFIG_CAVEAT:
    case EGL_TRANSPARENT_TYPE:
        return EGL_NONE;
    case EGL_RENDERABLE_TYPE:
    case EGL_CONFORMANT:
        return EGL_OPENGL_BIT;
    case EGL_SURFACE_TYPE:
        return EGL_PBUFFER_BIT |
               (swap_mode() == SwapMode::Copy ? EGL_SWAP_BEHAVIOR_PRESERVED_BIT : 0) |
               (config.visual != 0 ? EGL_WINDOW_BIT | EGL_PIXMAP_BIT : 0);
    case EGL_NATIVE_RENDERABLE:
        return config.visual != 0;
    case EGL_NATIVE_VISUAL_ID:
        return static_cast<EGLint>(config.visual);
    case EGL_NATIVE_VISUAL_TYPE:
        return config.visual != 0 ? 4 : EGL_NONE; // X's TrueColor
    case EGL_MAX_PBUFFER_WIDTH:
    case EGL_MAX_PBUFFER_HEIGHT:
        return MaxSurfaceSize;
    case EGL_MAX_PBUFFER_PIXELS:
        return MaxSurfaceSize * MaxSurfaceSize;
    case EGL_MAX_SWAP_INTERVAL:
        return 1;
    case EGL_BIND_TO_TEXTURE_RGB:
    case EGL_BIND_TO_TEXTURE_RGBA:
    case EGL_LEVEL:
    case EGL_LUMINANCE_SIZE:
    case EGL_ALPHA_MASK_SIZE:
    case EGL_MIN_SWAP_INTERVAL:
    case EGL_TRANSPARENT_RED_VALUE:
    case EGL_TRANSPARENT_GREEN_VALUE:
    case EGL_TRANSPARENT_BLUE_VALUE:
        return 0;
    default:
        return std::nullopt;
    }
}

std::optional<std::vector<const EglConfig*>>
choose_egl_configs(const std::vector<EglConfig>& configs, const EGLint* attributes) {
    Wishes wishes{{EGL_SURFACE_TYPE, EGL_WINDOW_BIT},
                  {EGL_RENDERABLE_TYPE, EGL_OPENGL_ES_BIT},
                  {EGL_COLOR_BUFFER_TYPE, EGL_RGB_BUFFER},
                  {EGL_LEVEL, 0},
                  {EGL_TRANSPARENT_TYPE, EGL_NONE}};
    for (const EGLint* at = attributes; at && at[0] != EGL_NONE; at += 2) {
        const bool known =
            at[0] == EGL_MATCH_NATIVE_PIXMAP || egl_config_attribute(EglConfig{}, at[0]);
        if (!known || (is_minimum(at[0]) && at[1] < 0 && at[1] != EGL_DONT_CARE))
            return std::nullopt;
        wishes[at[0]] = at[1];
    }
    std::vector<const EglConfig*> chosen;
    for (const EglConfig& config : configs)
        if (matches_all(config, wishes)) chosen.push_back(&config);
    std::ranges::sort(
        chosen, {}, [&](const EglConfig* config) { return sort_key(*config, wishes); });
    return chosen;
}

} // namespace ffgpu::gl
