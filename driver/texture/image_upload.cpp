#include "driver/texture/image_upload.h"

#include "driver/pixel/pixel_format.h"
#include "driver/texel/block_codec.h"
#include "driver/texel/texel_codec.h"

#include <cstring>

namespace ffgpu::gl {

namespace {

// Calls visitor(row of the source, number of the row) for all rows of all layers.
template <class Visitor>
void for_each_row(const PixelSource& source, Visitor&& visitor) {
    std::size_t number = 0;
    for (GLsizei z = 0; z < source.size.depth; ++z) {
        for (GLsizei y = 0; y < source.size.height; ++y)
            visitor(source.row(y, z), number++);
    }
}

void unpack_color_texels(const PixelSource& source,
                         const PixelState& transfer,
                         Format format,
                         std::byte* texels) {
    const bool unchanged = source.format != GL_COLOR_INDEX && keeps_colors(transfer);
    if (unchanged && unpack_fast(source, format, texels)) return;
    const std::size_t row = row_bytes(format, static_cast<std::uint32_t>(source.size.width));
    std::vector<PixelColor> colors;
    for_each_row(source, [&](const std::byte* pixels, std::size_t number) {
        unpack_transferred(source, transfer, pixels, colors);
        encode_colors(format, colors, texels + number * row);
    });
}

void unpack_depth_texels(const PixelSource& source,
                         const PixelState& transfer,
                         InternalFormat format,
                         std::byte* texels) {
    if (keeps_depths(transfer) && unpack_fast(source, format.format, texels)) return;
    const std::size_t width = source.width();
    const std::size_t row = row_bytes(format.format, static_cast<std::uint32_t>(width));
    const bool with_stencil = format.base == BaseFormat::DepthStencil &&
                              component_order(source.format).kind == PixelKind::DepthStencil;
    std::vector<double> depths(width);
    std::vector<std::int32_t> stencils(width);
    for_each_row(source, [&](const std::byte* pixels, std::size_t number) {
        std::byte* const to = texels + number * row;
        unpack_depths(source, pixels, depths.data());
        transfer_depths(transfer, depths);
        encode_depths(format.format, depths, to);
        if (!with_stencil) return;
        unpack_indices(source, pixels, stencils.data());
        transfer_stencil(transfer, stencils);
        for (std::size_t x = 0; x < width; ++x)
            to[4 * x] = static_cast<std::byte>(stencils[x] & 0xff);
    });
}

// Tightly packed r g b a bytes of one layer.
std::vector<std::byte>
rgba_layer(const PixelSource& source, const PixelState& transfer, GLsizei z) {
    PixelSource layer = source;
    layer.size.depth = 1;
    layer.layout.first += layer.layout.image_stride * static_cast<std::uint64_t>(z);
    std::vector<std::byte> rgba(layer.width() * static_cast<std::size_t>(layer.size.height) * 4);
    unpack_color_texels(layer, transfer, Format::Rgba8, rgba.data());
    return rgba;
}

} // namespace

std::vector<std::byte>
unpack_texels(const PixelSource& source, const PixelState& transfer, InternalFormat format) {
    const auto width = static_cast<std::uint32_t>(source.size.width);
    const auto height = static_cast<std::uint32_t>(source.size.height);
    const std::size_t layer =
        std::size_t{row_bytes(format.format, width)} * block_rows(format.format, height);
    std::vector<std::byte> texels(layer * static_cast<std::size_t>(source.size.depth));
    if (texels.empty()) return texels;
    if (is_compressed(format.format)) {
        for (GLsizei z = 0; z < source.size.depth; ++z) {
            const auto rgba = rgba_layer(source, transfer, z);
            const auto blocks = compress(format.format, rgba.data(), {width, height});
            std::memcpy(texels.data() + static_cast<std::size_t>(z) * layer, blocks.data(), layer);
        }
    } else if (format_info(format.format).is_depth) {
        unpack_depth_texels(source, transfer, format, texels.data());
    } else {
        unpack_color_texels(source, transfer, format.format, texels.data());
    }
    return texels;
}

} // namespace ffgpu::gl
