#include "model/work/level_lines.h"

#include <algorithm>

namespace ffgpu::work {
namespace {

// offset(texel) of the texels up to the next power of two.
template <class Offset>
std::vector<std::uint32_t> table(std::uint32_t texels, Offset&& offset) {
    std::vector<std::uint32_t> offsets(std::bit_ceil(texels));
    for (std::uint32_t i = 0; i < offsets.size(); ++i)
        offsets[i] = static_cast<std::uint32_t>(offset(i < texels ? i : texels - 1));
    return offsets;
}

// All bits but those of a place in the largest 2^n texels in a row, from a multiple of 2^n on, that
// have offsets in one line.
std::uint16_t first_texels(const std::vector<std::uint32_t>& offsets, unsigned line_shift) {
    constexpr std::uint32_t Most = 1u << 15; // coordinates stay apart from BorderTexel
    std::uint32_t texels = Most;
    for (std::uint32_t i = 1; i < offsets.size(); ++i)
        if ((offsets[i] ^ offsets[i - 1]) >> line_shift != 0) texels = std::min(texels, i & -i);
    return static_cast<std::uint16_t>(-texels);
}

} // namespace

LevelLines::LevelLines(const PlacedLevel& level, std::uint32_t line_bytes)
    : base_(level.base)
    , layer_bytes_(level.layer_bytes)
    , line_shift_(static_cast<unsigned>(std::countr_zero(line_bytes))) {
    const std::uint32_t width = level.layout.width * level.block_width;
    const std::uint32_t height = level.layout.height * level.block_height;
    if (level.expansion_log2 != 0 || layer_bytes_ >> 32 != 0 || width == 0 || height == 0) return;
    columns_ = table(width, [&](std::uint32_t x) { return level.column_offset(x); });
    rows_ = table(height, [&](std::uint32_t y) { return level.row_offset(y); });
    column_mask_ = static_cast<std::uint32_t>(columns_.size() - 1);
    row_mask_ = static_cast<std::uint32_t>(rows_.size() - 1);
    find_rectangles();
}

// Where the offsets of base, column and row in their lines never add up to a line, the line is that
// of the one beside that of the others. Layers that begin inside of lines have to lie in a part of
// a line each.
void LevelLines::find_rectangles() {
    const std::uint64_t line_bytes = std::uint64_t{1} << line_shift_;
    const std::uint64_t layer_grain = layer_bytes_ & (~layer_bytes_ + 1); // 0 of no bytes
    const bool in_parts = layer_grain != 0 && layer_grain < line_bytes;
    const std::uint64_t part = in_parts ? layer_grain : line_bytes;
    const auto last_byte = [&](const std::vector<std::uint32_t>& offsets) {
        std::uint64_t last = 0;
        for (const std::uint32_t offset : offsets)
            last = std::max<std::uint64_t>(last, in_parts ? offset : offset & (part - 1));
        return last;
    };
    if ((base_ & (part - 1)) + last_byte(columns_) + last_byte(rows_) >= part) return;
    const std::uint16_t x = first_texels(columns_, line_shift_);
    const std::uint16_t y = first_texels(rows_, line_shift_);
    firsts_ = {x, x, y, y};
}

} // namespace ffgpu::work
