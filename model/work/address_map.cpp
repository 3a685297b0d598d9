#include "model/work/address_map.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace ffgpu::work {
namespace {

constexpr std::uint64_t LevelAlignment = 512; // bytes: the longest line

// In rising order, each once.
void sort_lines(std::vector<std::uint64_t>& lines) {
    std::sort(lines.begin(), lines.end());
    lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
}

// The lines of an element, a texel or a block.
void add_element_lines(const PlacedLevel& level,
                       std::uint64_t at,
                       std::uint32_t line_bytes,
                       std::vector<std::uint64_t>& lines) {
    const auto add = [&lines](std::uint64_t line) {
        if (lines.empty() || lines.back() != line) lines.push_back(line);
    };
    if (level.expansion_log2 != 0) {
        for (std::uint32_t texel = 0; texel < ExpandedBlockBytes; texel += ExpandedTexelBytes)
            add(expanded_line(at, level.expansion_log2, texel, line_bytes));
        return;
    }
    add(quotient(at, line_bytes));
    add(quotient(at + level.layout.element_bytes - 1, line_bytes));
}

// The lines of the elements that bytes [begin, end) of the level are of, as device memory has it;
// some more than once.
void add_level_lines(const PlacedLevel& level,
                     const LevelLayout& device,
                     std::uint64_t begin,
                     std::uint64_t end,
                     std::uint32_t line_bytes,
                     std::vector<std::uint64_t>& lines) {
    const std::uint32_t element = level.layout.element_bytes;
    for (std::uint64_t row = begin / device.row_stride; row * device.row_stride < end; ++row) {
        const std::uint64_t first = row * device.row_stride;
        const auto from = static_cast<std::uint32_t>((std::max(begin, first) - first) / element);
        const std::uint64_t to =
            (std::min<std::uint64_t>(end - first, device.row_stride) - 1) / element;
        const auto rows_of_layer = device.layer_stride / device.row_stride;
        const std::uint64_t at =
            level.layer_address(static_cast<std::uint32_t>(row / rows_of_layer)) +
            level.layout.row_offset(static_cast<std::uint32_t>(row % rows_of_layer));
        for (std::uint32_t column = from; column <= to; ++column)
            add_element_lines(level, at + level.layout.column_offset(column), line_bytes, lines);
    }
}

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

TextureLines& AddressMap::Texture::own_lines() {
    if (lines.use_count() > 1) lines = std::make_shared<TextureLines>(*lines);
    return *lines;
}

const AddressMap::Texture& AddressMap::placed(const TextureImage& image) {
    Texture& texture = textures_[image.address];
    if (!texture.lines || !(texture.image == image)) {
        texture.image = image;
        texture.bytes = {image.address, image.address + texture_bytes(image.shape)};
        texture.lines = std::make_shared<TextureLines>();
        for (std::uint32_t level = 0; level < image.shape.levels; ++level)
            texture.lines->add(place_level(image, level), texture_shape_.line_bytes);
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

std::vector<std::uint64_t> AddressMap::memory_written(std::span<const ByteRange> ranges,
                                                      RewrittenLevel rewritten) {
    std::vector<std::uint64_t> lines;
    if (ranges.empty()) return lines;
    ByteRange all = ranges.front();
    for (const ByteRange& range : ranges)
        all = {std::min(all.begin, range.begin), std::max(all.end, range.end)};
    for (auto& [address, texture] : textures_) {
        if (address >= all.end) break;
        if (!texture.bytes.overlaps(all)) continue;
        for (std::uint32_t number = 0; number < texture.lines->levels.size(); ++number) {
            const LevelLayout device = level_layout(texture.image.shape, number);
            const std::uint64_t begin = address + device.offset;
            const ByteRange level{begin, begin + device.bytes};
            for (const ByteRange& range : ranges) {
                if (!range.overlaps(level)) continue;
                if (rewritten == RewrittenLevel::NewPlace) {
                    texture.own_lines().set(
                        number, place_level(texture.image, number), texture_shape_.line_bytes);
                    break;
                }
                add_level_lines(texture.lines->levels[number],
                                device,
                                std::max(range.begin, level.begin) - level.begin,
                                std::min(range.end, level.end) - level.begin,
                                texture_shape_.line_bytes,
                                lines);
            }
        }
    }
    sort_lines(lines);
    return lines;
}

std::vector<std::uint64_t> AddressMap::copied(const CopyRectangleCommand& copy,
                                              RewrittenLevel rewritten) {
    const Surface& to = copy.destination;
    const std::uint32_t pixel = format_info(to.format).block_bytes;
    const std::uint64_t first = to.address + std::uint64_t{copy.destination_y} * to.stride +
                                std::uint64_t{copy.destination_x} * pixel;
    std::vector<ByteRange> rows;
    for (std::uint32_t y = 0; y < copy.height && copy.width != 0; ++y) {
        const std::uint64_t begin = first + std::uint64_t{y} * to.stride;
        rows.push_back({begin, begin + std::uint64_t{copy.width} * pixel});
    }
    return memory_written(rows, rewritten);
}

bool AddressMap::holds_texels(const ByteRange& range) const {
    for (const auto& [address, texture] : textures_) {
        if (address >= range.end) break;
        if (texture.bytes.overlaps(range)) return true;
    }
    return false;
}

} // namespace ffgpu::work
