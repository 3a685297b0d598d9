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

std::vector<std::uint64_t>
AddressMap::memory_written(std::uint64_t at, std::uint64_t bytes, RewrittenLevel rewritten) {
    std::vector<std::uint64_t> lines;
    for (auto& [address, texture] : textures_) {
        if (address >= at + bytes) break;
        if (texture.levels.empty() || address + texture.bytes <= at) continue;
        for (std::uint32_t level = 0; level < texture.levels.size(); ++level) {
            const LevelLayout device = level_layout(texture.image.shape, level);
            const std::uint64_t begin = address + device.offset;
            if (begin >= at + bytes || begin + device.bytes <= at) continue;
            if (rewritten == RewrittenLevel::NewPlace)
                texture.set(level, place_level(texture.image, level), texture_shape_.line_bytes);
            else
                add_level_lines(texture.levels[level],
                                device,
                                std::max(at, begin) - begin,
                                std::min(at + bytes, begin + device.bytes) - begin,
                                texture_shape_.line_bytes,
                                lines);
        }
    }
    sort_lines(lines);
    return lines;
}

std::vector<std::uint64_t> AddressMap::copied(const CopyRectangleCommand& copy,
                                              RewrittenLevel rewritten) {
    std::vector<std::uint64_t> lines;
    if (copy.width == 0 || copy.height == 0) return lines;
    const Surface& to = copy.destination;
    const std::uint32_t pixel = format_info(to.format).block_bytes;
    const std::uint64_t first = to.address + std::uint64_t{copy.destination_y} * to.stride +
                                std::uint64_t{copy.destination_x} * pixel;
    const std::uint64_t row = std::uint64_t{copy.width} * pixel;
    if (rewritten == RewrittenLevel::NewPlace)
        return memory_written(
            first, (copy.height - 1u) * std::uint64_t{to.stride} + row, rewritten);
    for (std::uint32_t y = 0; y < copy.height; ++y) {
        const auto more = memory_written(first + std::uint64_t{y} * to.stride, row, rewritten);
        lines.insert(lines.end(), more.begin(), more.end());
    }
    sort_lines(lines);
    return lines;
}

void AddressMap::drawn_into(const Targets& targets) {
    Targets::for_each(targets, [this](const Surface& target) {
        if (target.format == Format::None) return;
        const Range drawn{target.address, target.address + target.bytes()};
        if (std::find(drawn_.begin(), drawn_.end(), drawn) != drawn_.end()) return;
        for (const auto& [address, texture] : textures_) {
            if (address >= drawn.end) break;
            if (texture.levels.empty() || address + texture.bytes <= drawn.begin) continue;
            return drawn_.push_back(drawn);
        }
    });
}

std::vector<std::uint64_t> AddressMap::take_drawn(const Registers& draw) {
    if (drawn_.empty()) return {};
    const bool reads = std::any_of(
        std::begin(draw.images), std::end(draw.images), [this](const TextureImage& image) {
            if (image.shape.kind == TextureKind::None) return false;
            const Range read{image.address, image.address + texture_bytes(image.shape)};
            return std::any_of(drawn_.begin(), drawn_.end(), [&](const Range& drawn) {
                return drawn.overlaps(read);
            });
        });
    if (!reads) return {};
    std::vector<std::uint64_t> lines;
    for (const Range& drawn : std::exchange(drawn_, {})) {
        const auto more = memory_written(drawn.begin, drawn.end - drawn.begin);
        lines.insert(lines.end(), more.begin(), more.end());
    }
    sort_lines(lines);
    return lines;
}

} // namespace ffgpu::work
