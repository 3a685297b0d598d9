#include "driver/lower/sampler.h"

#include "driver/math/conversion.h"
#include "driver/objects/texture_filter.h"
#include "driver/pixel/rgba8.h"

namespace ffgpu::gl {

namespace {

constexpr float LodLimit = 16;

// NaN is `low`.
constexpr float limit(float value, float low, float high) {
    return value >= high ? high : value > low ? value : low;
}

Wrap lower_wrap(GLenum wrap) {
    switch (wrap) {
    case GL_MIRRORED_REPEAT:
        return Wrap::MirroredRepeat;
    case GL_CLAMP:
        return Wrap::Clamp;
    case GL_CLAMP_TO_EDGE:
        return Wrap::ClampToEdge;
    case GL_CLAMP_TO_BORDER:
        return Wrap::ClampToBorder;
    case GL_MIRROR_CLAMP_EXT:
        return Wrap::MirrorClamp;
    case GL_MIRROR_CLAMP_TO_EDGE_EXT:
        return Wrap::MirrorClampToEdge;
    case GL_MIRROR_CLAMP_TO_BORDER_EXT:
        return Wrap::MirrorClampToBorder;
    default:
        return Wrap::Repeat;
    }
}

MipFilter lower_mip_filter(GLenum min_filter) {
    switch (min_filter) {
    case GL_NEAREST_MIPMAP_NEAREST:
    case GL_LINEAR_MIPMAP_NEAREST:
        return MipFilter::Nearest;
    case GL_NEAREST_MIPMAP_LINEAR:
    case GL_LINEAR_MIPMAP_LINEAR:
        return MipFilter::Linear;
    default:
        return MipFilter::None;
    }
}

bool is_linear_within_level(GLenum min_filter) {
    return min_filter == GL_LINEAR || min_filter == GL_LINEAR_MIPMAP_NEAREST ||
           min_filter == GL_LINEAR_MIPMAP_LINEAR;
}

// Signed with 8 fraction bits.
std::int16_t lower_lod(float lod) {
    return static_cast<std::int16_t>(round_to_int(limit(lod, -LodLimit, LodLimit) * 256.0f));
}

Compare lower_compare(GLenum function) {
    return static_cast<Compare>(function - GL_NEVER);
}

DepthMode lower_depth_mode(GLenum mode) {
    return mode == GL_ALPHA       ? DepthMode::Alpha
           : mode == GL_INTENSITY ? DepthMode::Intensity
                                  : DepthMode::Luminance;
}

// The border's colour as a texel of the format would read it (GL 1.5, 3.8.8 with table 3.15).
std::uint32_t lower_border_color(BaseFormat format, const std::array<float, 4>& color) {
    const auto [r, g, b, a] = color;
    switch (format) {
    case BaseFormat::Alpha:
        return pack_rgba8({0, 0, 0, a});
    case BaseFormat::Luminance:
        return pack_rgba8({r, r, r, 1});
    case BaseFormat::LuminanceAlpha:
        return pack_rgba8({r, r, r, a});
    case BaseFormat::Intensity:
        return pack_rgba8({r, r, r, r});
    case BaseFormat::Rgb:
        return pack_rgba8({r, g, b, 1});
    default:
        return pack_rgba8(color);
    }
}

bool is_depth(BaseFormat format) {
    return format == BaseFormat::Depth || format == BaseFormat::DepthStencil;
}

void lower_filter(const TextureObject& texture, Sampler& sampler) {
    sampler.filter = filter_in_force(texture);
    const bool needs_table =
        sampler.filter == TextureFilter::RipMap || sampler.filter == TextureFilter::SummedArea;
    if (!needs_table) return;
    if (const FilterTable* const table = table_in_force(texture)) {
        sampler.source_width = table->source_width;
        sampler.source_height = table->source_height;
    } else {
        sampler.filter = TextureFilter::Standard;
    }
}

} // namespace

BaseFormat sampled_format(const TextureObject& texture) {
    const BaseFormat format = texture.chain().base_format;
    if (!is_depth(format)) return format;
    switch (texture.parameters.depth_mode) {
    case GL_ALPHA:
        return BaseFormat::Alpha;
    case GL_INTENSITY:
        return BaseFormat::Intensity;
    default:
        return BaseFormat::Luminance;
    }
}

Sampler lower_sampler(const TextureObject& texture, float unit_lod_bias) {
    const TextureParameters& gl = texture.parameters;
    const TextureChain& chain = texture.chain();

    Sampler sampler;
    sampler.wrap = {lower_wrap(gl.wrap_s), lower_wrap(gl.wrap_t), lower_wrap(gl.wrap_r)};
    sampler.magnify_linear = gl.mag_filter == GL_LINEAR;
    sampler.minify_linear = is_linear_within_level(gl.min_filter);
    sampler.mip_filter = lower_mip_filter(gl.min_filter);
    sampler.base_level = static_cast<std::uint8_t>(chain.base);
    sampler.max_level = static_cast<std::uint8_t>(chain.last - chain.base);
    sampler.bias = lower_lod(gl.lod_bias + unit_lod_bias);
    sampler.min_lod = lower_lod(gl.min_lod);
    sampler.max_lod = lower_lod(gl.max_lod);
    sampler.max_anisotropy = static_cast<std::uint8_t>(limit(gl.max_anisotropy, 1, 16));
    sampler.depth_mode = lower_depth_mode(gl.depth_mode);
    sampler.compare = lower_compare(gl.compare_func);
    if (is_depth(chain.base_format)) {
        sampler.compare_enable = gl.compare_mode == GL_COMPARE_R_TO_TEXTURE;
        sampler.border_depth = unorm(gl.border_color[0], 24);
    }
    sampler.border_color = lower_border_color(chain.base_format, gl.border_color);
    lower_filter(texture, sampler);
    return sampler;
}

} // namespace ffgpu::gl
