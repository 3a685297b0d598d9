#include "driver/window_system/glx/choose.h"

#include <algorithm>
#include <array>

namespace ffgpu::gl {
namespace {

constexpr auto DontCare = static_cast<int>(GLX_DONT_CARE);

// How a configuration's value must stand to the wish.
enum class Match { Exact, AtLeast, Mask, Ignored };

Match match_of(int attribute) {
    switch (attribute) {
    case GLX_BUFFER_SIZE:
    case GLX_AUX_BUFFERS:
    case GLX_RED_SIZE:
    case GLX_GREEN_SIZE:
    case GLX_BLUE_SIZE:
    case GLX_ALPHA_SIZE:
    case GLX_DEPTH_SIZE:
    case GLX_STENCIL_SIZE:
    case GLX_ACCUM_RED_SIZE:
    case GLX_ACCUM_GREEN_SIZE:
    case GLX_ACCUM_BLUE_SIZE:
    case GLX_ACCUM_ALPHA_SIZE:
    case GLX_SAMPLE_BUFFERS:
    case GLX_SAMPLES:
    case GLX_FRAMEBUFFER_SRGB_CAPABLE_ARB: // All are; who does not enable it sees nothing of it.
        return Match::AtLeast;
    case GLX_RENDER_TYPE:
    case GLX_DRAWABLE_TYPE:
        return Match::Mask;
    case GLX_MAX_PBUFFER_WIDTH:
    case GLX_MAX_PBUFFER_HEIGHT:
    case GLX_MAX_PBUFFER_PIXELS:
    case GLX_SCREEN:
    case GLX_USE_GL:
        return Match::Ignored;
    default:
        return Match::Exact;
    }
}

bool matches(const GlxConfig& config, int attribute, int wish) {
    if (wish == DontCare) return true;
    // Who asks for no certain method is content with any (GLX_OML_swap_method).
    if (attribute == GLX_SWAP_METHOD_OML && wish == GLX_SWAP_UNDEFINED_OML) return true;
    const auto value = config_attribute(config, attribute);
    if (!value) return false;
    switch (match_of(attribute)) {
    case Match::AtLeast:
        return *value >= wish;
    case Match::Mask:
        return (*value & wish) == wish;
    case Match::Ignored:
        return true;
    case Match::Exact:
        break;
    }
    return *value == wish;
}

bool matches_all(const GlxConfig& config, const Wishes& wishes) {
    // With an identity nothing else counts (GLX 1.4, 3.3.3).
    if (const auto id = wishes.find(GLX_FBCONFIG_ID); id != wishes.end() && id->second != DontCare)
        return config.id == id->second;
    return std::ranges::all_of(
        wishes, [&](const auto& wish) { return matches(config, wish.first, wish.second); });
}

// The order as numbers: of two configurations the one with the lesser key comes first.
using Key = std::array<int, 8>;

// Sum of those of the attributes that the program asked for.
int wished_bits(const GlxConfig& config, const Wishes& wishes, std::initializer_list<int> list) {
    int bits = 0;
    for (const int attribute : list) {
        const auto wish = wishes.find(attribute);
        if (wish != wishes.end() && wish->second != DontCare && wish->second > 0)
            bits += *config_attribute(config, attribute);
    }
    return bits;
}

// "Larger is better" where the program wants some, else "none is better".
int larger_if_wished(const GlxConfig& config, const Wishes& wishes, int attribute) {
    const int value = *config_attribute(config, attribute);
    const auto wish = wishes.find(attribute);
    const bool wished = wish != wishes.end() && wish->second > 0;
    return wished ? -value : value;
}

Key sort_key(const GlxConfig& config, const Wishes& wishes) {
    const int accumulation = wished_bits(
        config,
        wishes,
        {GLX_ACCUM_RED_SIZE, GLX_ACCUM_GREEN_SIZE, GLX_ACCUM_BLUE_SIZE, GLX_ACCUM_ALPHA_SIZE});
    return {
        -wished_bits(config, wishes, {GLX_RED_SIZE, GLX_GREEN_SIZE, GLX_BLUE_SIZE, GLX_ALPHA_SIZE}),
        *config_attribute(config, GLX_BUFFER_SIZE),
        *config_attribute(config, GLX_DOUBLEBUFFER),
        *config_attribute(config, GLX_SAMPLES),
        larger_if_wished(config, wishes, GLX_DEPTH_SIZE),
        *config_attribute(config, GLX_STENCIL_SIZE),
        accumulation > 0 ? -accumulation : *config_attribute(config, GLX_ACCUM_RED_SIZE),
        config.id};
}

bool is_boolean_of_visuals(int attribute) {
    return attribute == GLX_USE_GL || attribute == GLX_RGBA || attribute == GLX_DOUBLEBUFFER ||
           attribute == GLX_STEREO;
}

} // namespace

std::optional<Wishes> read_config_wishes(const int* attributes) {
    Wishes wishes{{GLX_LEVEL, 0},
                  {GLX_STEREO, False},
                  {GLX_RENDER_TYPE, GLX_RGBA_BIT},
                  {GLX_DRAWABLE_TYPE, GLX_WINDOW_BIT}};
    for (const int* at = attributes; at && at[0] != 0; at += 2) {
        if (!config_attribute(GlxConfig{}, at[0])) return std::nullopt;
        wishes[at[0]] = at[1];
    }
    return wishes;
}

std::optional<Wishes> read_visual_wishes(const int* attributes) {
    Wishes wishes{
        {GLX_RGBA, False}, {GLX_DOUBLEBUFFER, False}, {GLX_STEREO, False}, {GLX_LEVEL, 0}};
    for (const int* at = attributes; at && at[0] != 0; ++at) {
        if (!config_attribute(GlxConfig{}, at[0])) return std::nullopt;
        if (is_boolean_of_visuals(at[0])) {
            wishes[at[0]] = True;
        } else {
            wishes[at[0]] = at[1];
            ++at;
        }
    }
    return wishes;
}

std::vector<const GlxConfig*> choose_configs(const std::vector<GlxConfig>& configs,
                                             const Wishes& wishes) {
    std::vector<const GlxConfig*> chosen;
    for (const GlxConfig& config : configs)
        if (matches_all(config, wishes)) chosen.push_back(&config);
    std::ranges::sort(
        chosen, {}, [&](const GlxConfig* config) { return sort_key(*config, wishes); });
    return chosen;
}

} // namespace ffgpu::gl
