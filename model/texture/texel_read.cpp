#include "model/texture/texel_read.h"

#include "model/arith/fxt1.h"
#include "model/texture/depth_compare.h"
#include "model/texture/s3tc.h"
#include "model/texture/texel_decode.h"

namespace ffgpu {
namespace {

const std::byte* block_address(const TextureUnit& unit, unsigned level, const StoredTexel& texel) {
    const FormatInfo& info = format_info(unit.format);
    return unit.texels + unit.levels.offset[level] +
           std::size_t{texel.layer} * unit.levels.layer_stride[level] +
           std::size_t{texel.y / info.block_height} * unit.levels.row_stride[level] +
           std::size_t{texel.x / info.block_width} * info.block_bytes;
}

Rgba border_texel(const TextureUnit& unit, std::uint32_t reference) {
    const Sampler& sampler = unit.sampler;
    if (format_info(unit.format).is_depth)
        return depth_color(sampler, reference, sampler.border_depth & 0xffffff);
    Rgba color{};
    for (unsigned channel = 0; channel < 4; ++channel)
        color[channel] = static_cast<std::uint8_t>(sampler.border_color >> (8 * channel));
    return color;
}

Rgba decode_color(Format format, const std::byte* block, const StoredTexel& texel) {
    switch (format_info(format).block_width) {
    case 8:
        return decode_fxt1(block, texel.x % 8, texel.y % 4, format == Format::Fxt1Rgba);
    case 4:
        return decode_s3tc(format, block, texel.x % 4, texel.y % 4);
    default:
        return decode_color_texel(format, block);
    }
}

Rgba decode(const TextureUnit& unit,
            const std::byte* block,
            const StoredTexel& texel,
            std::uint32_t reference) {
    const FormatInfo& info = format_info(unit.format);
    if (info.is_depth)
        return depth_color(unit.sampler, reference, decode_depth_texel(unit.format, block));
    const Rgba color = decode_color(unit.format, block, texel);
    return unit.srgb ? linear_from_srgb(color) : color;
}

Rgba told(TexelObserver* observer, std::span<const std::byte> stored, const Rgba& color) {
    if (observer) observer->texel(stored, color);
    return color;
}

Rgba read_from_level(const TextureUnit& unit,
                     unsigned level,
                     const StoredTexel& texel,
                     std::uint32_t reference,
                     TexelObserver* observer) {
    if (observer) observer->read(level, texel.layer, texel.x, texel.y);
    constexpr std::uint32_t Border = TexelAccess::BorderTexel;
    if (texel.x == Border || texel.y == Border || texel.layer == Border)
        return told(observer, {}, border_texel(unit, reference));
    const std::byte* const block = block_address(unit, level, texel);
    return told(observer,
                {block, format_info(unit.format).block_bytes},
                decode(unit, block, texel, reference));
}

} // namespace

std::uint16_t stored_coordinate(const TextureUnit& unit, std::int32_t index, std::int32_t size) {
    const std::int32_t stored = index + unit.border;
    const bool outside = stored < 0 || stored >= size + 2 * unit.border;
    return outside ? TexelAccess::BorderTexel : static_cast<std::uint16_t>(stored);
}

Rgba read_texel(const TextureUnit& unit,
                const TexelPlace& place,
                std::uint32_t reference,
                TexelObserver* observer) {
    const auto stored = [&](unsigned axis, std::int32_t index) -> std::uint16_t {
        if (axis >= unit.dimensions) return 0;
        return stored_coordinate(unit, index, level_extent(unit, axis, place.level));
    };
    const std::uint16_t x = stored(0, place.x), y = stored(1, place.y), z = stored(2, place.z);
    const auto layer =
        static_cast<std::uint16_t>(z == TexelAccess::BorderTexel ? z : z + place.face);
    return read_from_level(unit, place.level, {x, y, layer}, reference, observer);
}

Rgba read_stored_texel(const TextureUnit& unit, const StoredTexel& texel, TexelObserver* observer) {
    return read_from_level(unit, 0, texel, 0, observer);
}

} // namespace ffgpu
