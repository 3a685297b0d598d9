#include "model/texture/texture_unit.h"

#include "model/texture/wide_filters.h"

#include <algorithm>

namespace ffgpu {
namespace {

bool is_texture_format(Format format) {
    return format > Format::None && format < Format::Stencil8;
}

// Registers come from captures too, so nothing about the shape is taken for granted.
bool is_sane(const TextureShape& shape) {
    if (shape.kind == TextureKind::None || shape.kind > TextureKind::Rectangle) return false;
    if (!is_texture_format(shape.format) || shape.levels == 0 || shape.border > 1) return false;
    const bool three_d = shape.kind == TextureKind::ThreeD;
    const std::uint32_t most = three_d ? MaxTexture3dSize : MaxTextureSize;
    const auto fits = [most](std::uint32_t size) { return size >= 1 && size <= most; };
    return fits(shape.width) && fits(shape.height) && (!three_d || fits(shape.depth));
}

void set_levels(TextureUnit& unit, const TextureShape& shape) {
    for (unsigned level = 0; level < shape.levels; ++level) {
        const LevelLayout layout = level_layout(shape, level);
        unit.levels.offset[level] = static_cast<std::uint32_t>(layout.offset);
        unit.levels.row_stride[level] = layout.row_stride;
        unit.levels.layer_stride[level] = layout.layer_stride;
    }
}

unsigned filter_dimensions(TextureKind kind) {
    return kind == TextureKind::OneD ? 1 : kind == TextureKind::ThreeD ? 3 : 2;
}

// Rectangles know the clamping modes only; another one (no driver sets it) is taken as to-edge.
Wrap usable_wrap(Wrap wrap, bool normalized) {
    const bool clamps =
        wrap == Wrap::Clamp || wrap == Wrap::ClampToEdge || wrap == Wrap::ClampToBorder;
    return normalized || clamps ? wrap : Wrap::ClampToEdge;
}

void set_axis(TextureUnit& unit, unsigned axis, std::uint32_t size) {
    unit.size[axis] = static_cast<std::int32_t>(size);
    unit.extent[axis] = unit.normalized ? 1.0f : static_cast<float>(size);
    unit.density[axis] = unit.normalized ? static_cast<float>(size) : 1.0f;
    const Wrap wrap = usable_wrap(unit.sampler.wrap[axis], unit.normalized);
    unit.nearest_rules[axis] = wrap_rule(wrap, false);
    unit.linear_rules[axis] = wrap_rule(wrap, true);
    const bool border = unit.nearest_rules[axis].border || unit.linear_rules[axis].border;
    if (axis < unit.dimensions && border && unit.border == 0) unit.border_color = true;
}

// GL 1.5, 3.8.9: the switch lies at 1/2 where a linear filter magnifies and texels, not levels
// alone, are chosen by the nearest when minifying, so that the sharper picture is not the farther.
std::int32_t magnify_limit(const Sampler& sampler) {
    const bool half =
        sampler.magnify_linear && !sampler.minify_linear && sampler.mip_filter != MipFilter::None;
    return half ? 128 : 0;
}

// Registers may ask for a filter that this image is not made for.
TextureFilter usable_filter(const TextureShape& shape, const Sampler& sampler) {
    if (shape.kind != TextureKind::TwoD || format_info(shape.format).is_depth)
        return TextureFilter::Standard;
    const std::uint32_t width = sampler.source_width, height = sampler.source_height;
    std::uint32_t columns = 0, rows = 0; // of the image that the filter reads
    if (sampler.filter == TextureFilter::RipMap) {
        columns = rip_offset(width, rip_levels(width));
        rows = rip_offset(height, rip_levels(height));
    } else if (sampler.filter == TextureFilter::SummedArea) {
        columns = TableChannels * width;
        rows = height;
    } else {
        return sampler.filter;
    }
    const bool fits = shape.format == Format::Rgba8 && shape.border == 0 && width > 0 &&
                      height > 0 && columns <= shape.width && rows <= shape.height;
    return fits ? sampler.filter : TextureFilter::Standard;
}

unsigned most_probes(const Sampler& sampler, TextureFilter filter) {
    const unsigned probes = std::clamp<unsigned>(sampler.max_anisotropy, 1, MaxProbes);
    const bool is_ellipse = filter == TextureFilter::Elliptic || filter == TextureFilter::Feline;
    if (is_ellipse && probes == 1) return MaxProbes;
    // Probes that each take the nearest texel would add nothing but noise.
    return sampler.minify_linear ? probes : 1;
}

} // namespace

TextureUnit compile_texture_unit(const TextureImage& image,
                                 const Sampler& sampler,
                                 std::span<const std::byte> memory) {
    TextureUnit unit;
    TextureShape shape = image.shape;
    shape.levels = std::min(shape.levels, MaxTextureLevels);
    if (!is_sane(shape)) return unit;
    if (image.address > memory.size() || texture_bytes(shape) > memory.size() - image.address)
        return unit;

    unit.valid = true;
    unit.kind = shape.kind;
    unit.format = shape.format;
    unit.srgb = image.srgb && !format_info(shape.format).is_depth;
    unit.dimensions = filter_dimensions(shape.kind);
    unit.border = static_cast<std::int32_t>(shape.border);
    unit.last_level = std::min<std::uint32_t>(sampler.max_level, shape.levels - 1);
    unit.texels = memory.data() + image.address;
    unit.normalized = shape.kind != TextureKind::Rectangle;
    unit.sampler = sampler;
    set_levels(unit, shape);
    unit.filter = usable_filter(shape, sampler);
    const bool table =
        unit.filter == TextureFilter::RipMap || unit.filter == TextureFilter::SummedArea;
    if (table) unit.srgb = false; // Words are no codes.
    set_axis(unit, 0, table ? sampler.source_width : shape.width);
    set_axis(unit, 1, table ? sampler.source_height : shape.height);
    set_axis(unit, 2, shape.kind == TextureKind::ThreeD ? shape.depth : 1);
    unit.magnify_limit = magnify_limit(sampler);
    unit.max_probes = most_probes(sampler, unit.filter);
    return unit;
}

} // namespace ffgpu
