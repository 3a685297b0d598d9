#include "driver/pixel/pixel_format.h"
#include "driver/texel/block_codec.h"
#include "driver/texel/texel_codec.h"
#include "driver/texture/image_upload.h"

#include <cstring>

namespace ffgpu::gl {

namespace {

// Rows of texels that are not compressed.
class RowPacker {
public:
    RowPacker(const PixelDestination& destination, Format format)
        : destination_(destination)
        , format_(format)
        , kind_(component_order(destination.format).kind)
        , colors_(destination.width())
        , depths_(destination.width())
        , words_(destination.width()) {}

    void operator()(const std::byte* texels, std::byte* row) {
        if (kind_ == PixelKind::Depth) {
            decode_depths(format_, texels, depths_);
            pack_depths(destination_, row, depths_.data());
        } else if (kind_ == PixelKind::DepthStencil) {
            std::memcpy(words_.data(), texels, words_.size() * sizeof words_[0]);
            pack_depth_stencil(destination_, row, words_.data());
        } else {
            decode_colors(format_, texels, colors_);
            pack_colors(destination_, row, colors_.data());
        }
    }

private:
    const PixelDestination& destination_;
    Format format_;
    PixelKind kind_;
    std::vector<PixelColor> colors_;
    std::vector<double> depths_;
    std::vector<std::uint32_t> words_;
};

} // namespace

void pack_texels(const PixelDestination& destination,
                 InternalFormat format,
                 const std::byte* texels) {
    const auto width = static_cast<std::uint32_t>(destination.size.width);
    const auto height = static_cast<std::uint32_t>(destination.size.height);
    const bool compressed = is_compressed(format.format);
    // What is decompressed is stored as r g b a; DXT1 without alpha decodes to alpha 1.
    const Format stored = compressed ? Format::Rgba8 : format.format;
    const std::size_t layer =
        std::size_t{row_bytes(format.format, width)} * block_rows(format.format, height);
    RowPacker pack(destination, stored);
    for (GLsizei z = 0; z < destination.size.depth; ++z, texels += layer) {
        const std::vector<std::byte> decoded =
            compressed ? decompress(format.format, texels, {width, height})
                       : std::vector<std::byte>{};
        const std::byte* rows = compressed ? decoded.data() : texels;
        for (GLsizei y = 0; y < destination.size.height; ++y, rows += row_bytes(stored, width))
            pack(rows, destination.row(y, z));
    }
}

} // namespace ffgpu::gl
