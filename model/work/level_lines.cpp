#include "model/work/level_lines.h"

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
}

} // namespace ffgpu::work
