#include "driver/objects/texture_filter.h"

#include "model/device/filter_tables.h"

#include <algorithm>

namespace ffgpu::gl {
namespace {

bool is_color(BaseFormat base) {
    return base != BaseFormat::None && base <= BaseFormat::Rgba;
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
    switch (texture.parameters.filter) {
    case GL_BICUBIC_FILTER_FFGPU:
        return TextureFilter::Bicubic;
    case GL_ELLIPTIC_FILTER_FFGPU:
        return TextureFilter::Elliptic;
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
