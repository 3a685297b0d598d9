// PlacedLevel: a level of a texture, or a surface, in the explored machine's memory: where each
// texel of it lies, and in which line.

#pragma once

#include "model/work/image_layout.h"
#include "model/work/texel_line.h"

#include <array>
#include <cstdint>

namespace ffgpu::work {

struct PlacedLevel {
    ImageLayout layout;
    std::uint64_t base = 0;
    std::uint64_t layer_bytes = 0;
    std::uint32_t block_width = 1; // texels of an element (4x4 for S3TC)
    std::uint32_t block_height = 1;
    std::uint32_t border = 0;
    std::uint32_t samples = 1; // of a pixel; they lie together
    bool compressed = false;
    unsigned expansion_log2 = 0; // bytes of a block's texels over the block's; 0: not expanded

    // Texel (x, y) of layer `layer`, borders counted from 0 as TexelAccess does.
    std::uint64_t address(std::uint32_t x, std::uint32_t y, std::uint32_t layer) const {
        return layer_address(layer) + column_offset(x) + row_offset(y);
    }
    // Its parts.
    std::uint64_t layer_address(std::uint32_t layer) const { return base + layer * layer_bytes; }
    std::uint64_t column_offset(std::uint32_t x) const {
        return layout.column_offset(quotient(x, block_width));
    }
    std::uint64_t row_offset(std::uint32_t y) const {
        return layout.row_offset(quotient(y, block_height));
    }

    // Of the pixels of the quad whose first is (x, y).
    std::array<std::uint64_t, 4> quad_addresses(std::uint32_t x, std::uint32_t y) const {
        if (block_width == 1 && layout.has_square_at(x, y)) { // Most do.
            const std::uint64_t lower = base + layout.offset(x, y);
            const std::uint64_t upper = lower + layout.row_step();
            const std::uint64_t pixel = layout.element_bytes;
            return {lower, lower + pixel, upper, upper + pixel};
        }
        const std::uint64_t left = base + column_offset(x), right = base + column_offset(x + 1);
        const std::uint64_t lower = row_offset(y), upper = row_offset(y + 1);
        return {left + lower, right + lower, left + upper, right + upper};
    }

    // The texel's line, of `line_bytes`.
    std::uint64_t
    line(std::uint32_t x, std::uint32_t y, std::uint32_t layer, std::uint32_t line_bytes) const {
        const std::uint64_t at = address(x, y, layer);
        if (expansion_log2 == 0) return quotient(at, line_bytes);
        const std::uint32_t texel =
            remainder(y, block_height) * block_width + remainder(x, block_width);
        return expanded_line(at, expansion_log2, texel * ExpandedTexelBytes, line_bytes);
    }
};

} // namespace ffgpu::work
