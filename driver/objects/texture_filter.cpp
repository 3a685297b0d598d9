#include "driver/objects/texture_filter.h"

#include "model/device/filter_tables.h"

#include <algorithm>

namespace ffgpu::gl {
namespace {

bool is_color(BaseFormat base) {
    return base != BaseFormat::None && base <= BaseFormat::Rgba;
}

// Texels that a program wants to see one by one are left to it.
GLenum wanted_filter(const TextureObject& texture) {
    const bool forced = texture.forced_filter != 0 && texture.parameters.min_filter != GL_NEAREST;
    return forced ? texture.forced_filter : texture.parameters.filter;
}

} // namespace

TextureFilter filter_in_force(const TextureObject& texture) {
    const TextureChain& chain = texture.chain();
    const TextureShape& shape = chain.shape;
    if (shape.kind != TextureKind::TwoD || shape.border != 0 || !is_color(chain.base_format))
        return TextureFilter::Standard;
    const TextureLevel& source = texture.level(0, chain.base);
    const auto width = static_cast<std::uint32_t>(source.width);
    const auto height = static_cast<std::uint32_t>(source.height);
    switch (wanted_filter(texture)) {
    case GL_BICUBIC_FILTER_FFGPU:
        return TextureFilter::Bicubic;
    case GL_ELLIPTIC_FILTER_FFGPU:
        return TextureFilter::Elliptic;
    case GL_FELINE_FILTER_FFGPU:
        return TextureFilter::Feline;
    case GL_RIP_MAP_FILTER_FFGPU:
        return std::max(rip_offset(width, rip_levels(width)),
                        rip_offset(height, rip_levels(height))) <= MaxTextureSize
                   ? TextureFilter::RipMap
                   : TextureFilter::Standard;
    case GL_SUMMED_AREA_FILTER_FFGPU:
        return TableChannels * width <= MaxTextureSize ? TextureFilter::SummedArea
                                                       : TextureFilter::Standard;
    default:
        return TextureFilter::Standard;
    }
}

const FilterTable* table_in_force(const TextureObject& texture) {
    const FilterTable& table = texture.filter_table;
    const TextureFilter filter = filter_in_force(texture);
    return table.block && table.filter == filter ? &table : nullptr;
}

} // namespace ffgpu::gl
