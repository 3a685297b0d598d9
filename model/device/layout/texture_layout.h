// Where the texels of a texture lie in device memory: the one statement that driver, sampler and
// timing model share. Level 0 comes first; within a level layer after layer (slices of a 3-D
// texture, the six faces of a cube map in OpenGL's order +x -x +y -y +z -z), within a layer row
// after row (rows of blocks for compressed formats). Each level begins at a multiple of 64 bytes.
// An image with a border of one texel is stored with it: its first texel is (-1, -1).

#pragma once

#include "model/device/layout/formats.h"

#include <algorithm>
#include <cstdint>

namespace ffgpu {

enum class TextureKind : std::uint8_t { None, OneD, TwoD, ThreeD, Cube, Rectangle };

struct TextureShape {
    TextureKind kind = TextureKind::None;
    Format format = Format::None;
    std::uint32_t width = 0; // Of level 0, in texels, without the border.
    std::uint32_t height = 1;
    std::uint32_t depth = 1;
    std::uint32_t levels = 1;
    std::uint32_t border = 0; // 0 or 1.

    bool operator==(const TextureShape&) const = default;
};

struct LevelLayout {
    std::uint32_t width, height, depth; // In texels, without the border; depth is 1 for cubes.
    std::uint32_t layers;               // Stored layers: depth and border, or six faces.
    std::uint32_t row_stride;           // Bytes from a row (of blocks) to the next.
    std::uint32_t layer_stride;         // Bytes from a layer to the next.
    std::uint64_t offset;               // Of the level's first byte from the texture's address.
    std::uint64_t bytes;                // layers * layer_stride.
};

constexpr std::uint32_t level_size(std::uint32_t size, std::uint32_t level) {
    return std::max<std::uint32_t>(1, size >> level);
}

// Layout of level `level` < shape.levels, of a texture with dimensions as in TextureShape.
constexpr LevelLayout level_layout(const TextureShape& shape, std::uint32_t level) {
    LevelLayout layout{};
    std::uint64_t offset = 0;
    for (std::uint32_t i = 0;; ++i) {
        const bool three_d = shape.kind == TextureKind::ThreeD;
        const std::uint32_t border_y = shape.kind == TextureKind::OneD ? 0 : 2 * shape.border;
        layout.width = level_size(shape.width, i);
        layout.height = level_size(shape.height, i);
        layout.depth = three_d ? level_size(shape.depth, i) : 1;
        layout.layers = shape.kind == TextureKind::Cube ? 6
                        : three_d                       ? layout.depth + 2 * shape.border
                                                        : 1;
        layout.row_stride = row_bytes(shape.format, layout.width + 2 * shape.border);
        layout.layer_stride =
            layout.row_stride * block_rows(shape.format, layout.height + border_y);
        layout.offset = offset;
        layout.bytes = std::uint64_t{layout.layers} * layout.layer_stride;
        if (i == level) return layout;
        offset = (offset + layout.bytes + 63) & ~std::uint64_t{63};
    }
}

// Bytes of the whole texture, all levels.
constexpr std::uint64_t texture_bytes(const TextureShape& shape) {
    const LevelLayout last = level_layout(shape, shape.levels - 1);
    return last.offset + last.bytes;
}

} // namespace ffgpu
