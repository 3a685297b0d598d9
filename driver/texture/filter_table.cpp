#include "driver/texture/filter_table.h"

#include "driver/ffgpu_texture_filter.h"
#include "driver/texel/block_codec.h"
#include "driver/texel/texel_codec.h"
#include "driver/texture/mipmap.h"
#include "model/arith/srgb.h"
#include "model/device/filter_tables.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace ffgpu::gl {
namespace {

constexpr std::size_t TexelBytes = 4;

TextureLevel level_of(std::uint32_t width, std::uint32_t height) {
    TextureLevel level;
    level.format = {.base = BaseFormat::Rgba, .format = Format::Rgba8};
    level.width = static_cast<GLsizei>(width);
    level.height = static_cast<GLsizei>(height);
    level.depth = 1;
    return level;
}

ColorImage halved(const ColorImage& from, std::uint32_t width, std::uint32_t height) {
    return {width,
            height,
            halve_image(level_of(from.width, from.height), level_of(width, height), from.texels)};
}

void paste(const ColorImage& part, std::uint32_t x, std::uint32_t y, ColorImage& whole) {
    const std::size_t bytes = TexelBytes * part.width;
    for (std::size_t row = 0; row < part.height; ++row)
        std::memcpy(whole.texels.data() + TexelBytes * ((y + row) * whole.width + x),
                    part.texels.data() + row * bytes,
                    bytes);
}

// What a texel's components are as a colour to texture with (GL 1.5, table 3.15): decode_colors()
// gives luminance and intensity as red.
PixelColor spread(BaseFormat base, PixelColor color) {
    switch (base) {
    case BaseFormat::Alpha:
        return {0, 0, 0, color[3]};
    case BaseFormat::Luminance:
        return {color[0], color[0], color[0], 1};
    case BaseFormat::LuminanceAlpha:
        return {color[0], color[0], color[0], color[3]};
    case BaseFormat::Intensity:
        return {color[0], color[0], color[0], color[0]};
    default:
        return color;
    }
}

// Level `base` as a filter reads it: as light, if its codes are sRGB.
ColorImage sampled_image(DeviceMemory memory, const TextureObject& texture, unsigned number) {
    const TextureLevel& level = texture.level(0, number);
    const TexelBox box = whole_box(level);
    ColorImage image{box.width, box.height, read_texels(memory, texture, {0, number}, box)};
    if (is_compressed(level.format.format)) {
        image.texels =
            decompress(level.format.format, image.texels.data(), {box.width, box.height});
    } else if (level.format.format != Format::Rgba8) {
        std::vector<PixelColor> colors(std::size_t{box.width} * box.height);
        decode_colors(level.format.format, image.texels.data(), colors);
        for (PixelColor& color : colors)
            color = spread(level.format.base, color);
        image.texels.resize(TexelBytes * colors.size());
        encode_colors(Format::Rgba8, colors, image.texels.data());
    }
    if (!level.format.srgb) return image;
    for (std::size_t i = 0; i < image.texels.size(); ++i)
        if (i % TexelBytes != 3)
            image.texels[i] = static_cast<std::byte>(
                SrgbToLinear8[std::to_integer<std::size_t>(image.texels[i])]);
    return image;
}

} // namespace

ColorImage make_rip_map(const ColorImage& source) {
    const std::uint32_t across = rip_levels(source.width), down = rip_levels(source.height);
    ColorImage whole{rip_offset(source.width, across), rip_offset(source.height, down), {}};
    whole.texels.resize(TexelBytes * whole.width * whole.height);
    ColorImage narrow = source;
    for (std::uint32_t i = 0; i < across; ++i) {
        if (i > 0) narrow = halved(narrow, level_size(source.width, i), source.height);
        ColorImage part = narrow;
        for (std::uint32_t j = 0; j < down; ++j) {
            if (j > 0) part = halved(part, part.width, level_size(source.height, j));
            paste(part, rip_offset(source.width, i), rip_offset(source.height, j), whole);
        }
    }
    return whole;
}

ColorImage make_summed_area_table(const ColorImage& source) {
    ColorImage table{TableChannels * source.width, source.height, {}};
    table.texels.resize(TexelBytes * table.width * table.height);
    std::vector<std::uint32_t> above(table.width); // of the row above, by word
    const std::byte* texel = source.texels.data();
    for (std::size_t y = 0; y < source.height; ++y) {
        std::array<std::uint32_t, TableChannels> row{};
        for (std::size_t word = 0; word < table.width; ++word, ++texel) {
            row[word % TableChannels] += std::to_integer<std::uint32_t>(*texel);
            above[word] += row[word % TableChannels];
        }
        std::memcpy(table.texels.data() + y * TexelBytes * table.width,
                    above.data(),
                    TexelBytes * table.width);
    }
    return table;
}

void bring_filter_table(DeviceMemory memory, TextureObject& texture) {
    const TextureFilter filter = filter_in_force(texture);
    if (filter != TextureFilter::RipMap && filter != TextureFilter::SummedArea) return;
    FilterTable& table = texture.filter_table;
    if (table.filter == filter && table.current) return;
    const ColorImage source = sampled_image(memory, texture, texture.chain().base);
    const ColorImage image =
        filter == TextureFilter::RipMap ? make_rip_map(source) : make_summed_area_table(source);
    DeviceBlock block = DeviceBlock::allocate(memory.allocator, image.texels.size());
    if (!block) {
        table = {};
        return;
    }
    memory.device.write_memory(block.address(), image.texels);
    table = {.filter = filter,
             .block = std::move(block),
             .shape = {.kind = TextureKind::TwoD,
                       .format = Format::Rgba8,
                       .width = image.width,
                       .height = image.height},
             .source_width = static_cast<std::uint16_t>(source.width),
             .source_height = static_cast<std::uint16_t>(source.height),
             .current = !texture.is_drawn_to()};
}

} // namespace ffgpu::gl
