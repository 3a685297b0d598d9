#include "model/work/address_map.h"

#include <bit>

namespace ffgpu::work {
namespace {

constexpr std::uint64_t LevelAlignment = 512; // bytes: the longest line

} // namespace

std::uint64_t AddressMap::place(std::uint64_t bytes) {
    const std::uint64_t base = next_;
    next_ += (bytes + LevelAlignment - 1) / LevelAlignment * LevelAlignment;
    return base;
}

PlacedLevel AddressMap::place_level(const TextureImage& image, std::uint32_t level) {
    const FormatInfo& format = format_info(image.shape.format);
    const LevelLayout device = level_layout(image.shape, level);
    const std::uint32_t border = image.shape.border;
    const std::uint32_t border_y = image.shape.kind == TextureKind::OneD ? 0 : border;

    PlacedLevel placed;
    placed.block_width = format.block_width;
    placed.block_height = format.block_height;
    placed.border = border;
    placed.compressed = format.block_width > 1;
    if (placed.compressed && texture_shape_.contents == TexelContents::Texels)
        placed.expansion_log2 =
            static_cast<unsigned>(std::countr_zero(ExpandedBlockBytes / format.block_bytes));
    placed.layout =
        ImageLayout::make(texture_shape_.layout,
                          texture_shape_.block_width,
                          texture_shape_.superblock_width,
                          (device.width + 2 * border + placed.block_width - 1) / placed.block_width,
                          block_rows(image.shape.format, device.height + 2 * border_y),
                          format.block_bytes);
    placed.layer_bytes = placed.layout.bytes();
    placed.base = place(placed.layer_bytes * device.layers);
    return placed;
}

const AddressMap::Texture& AddressMap::placed(const TextureImage& image) {
    Texture& texture = textures_[image.address];
    if (texture.levels.empty() || !(texture.image == image)) {
        texture.image = image;
        texture.bytes = texture_bytes(image.shape);
        texture.clear();
        for (std::uint32_t level = 0; level < image.shape.levels; ++level)
            texture.add(place_level(image, level), texture_shape_.line_bytes);
    }
    return texture;
}

const PlacedLevel& AddressMap::surface(const Surface& surface, const CacheShape& cache) {
    const auto key = std::tuple(surface.address,
                                surface.format,
                                std::uint32_t{surface.width},
                                std::uint32_t{surface.height},
                                std::uint32_t{surface.samples});
    const auto [entry, is_new] = surfaces_.try_emplace(key);
    if (is_new) {
        PlacedLevel& placed = entry->second;
        placed.samples = surface.samples;
        placed.layout =
            ImageLayout::make(cache.layout,
                              cache.block_width,
                              cache.block_width,
                              surface.width,
                              surface.height,
                              format_info(surface.format).block_bytes * surface.samples);
        placed.layer_bytes = placed.layout.bytes();
        placed.base = place(placed.layer_bytes);
    }
    return entry->second;
}

void AddressMap::memory_written(std::uint64_t at, std::uint64_t bytes) {
    for (auto& [address, texture] : textures_) {
        if (address >= at + bytes) break;
        if (texture.levels.empty() || address + texture.bytes <= at) continue;
        for (std::uint32_t level = 0; level < texture.levels.size(); ++level) {
            const LevelLayout device = level_layout(texture.image.shape, level);
            const std::uint64_t begin = address + device.offset;
            if (begin < at + bytes && begin + device.bytes > at) {
                texture.set(level, place_level(texture.image, level), texture_shape_.line_bytes);
            }
        }
    }
}

} // namespace ffgpu::work
