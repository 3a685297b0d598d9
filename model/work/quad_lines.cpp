#include "model/work/quad_lines.h"

#include <array>

namespace ffgpu::work {
namespace {

constexpr std::uint16_t Border = TexelAccess::BorderTexel;

// 2x2 texels of one layer, none of them the border colour's, as they lie in memory.
bool is_plain_square(const LevelLines& level, const TexelAccess& access) {
    return access.linear == 3 && level.has_tables() && access.x0 != Border && access.x1 != Border &&
           access.y0 != Border && access.y1 != Border && access.layer0 != Border;
}

} // namespace

// Most accesses fall on the line of the texel before.
void QuadLines::add_other(const TextureLines& texture, const TexelAccess& access) {
    make_room(MostOfAccess);
    const PlacedLevel& placed = texture.levels[access.level];
    const LevelLines& level = texture.lines[access.level];
    expands_blocks_ |= placed.compressed && placed.expansion_log2 == 0;
    if (!is_plain_square(level, access)) return add_corners(placed, access);
    reads_ += 4;
    const LevelLines::Rectangles rectangles = level.rectangles(access);
    if (merges_) {
        LastRead& last = last_[access.level & 1]; // In place: one_store.h.
        last.level = &level;
        last.layer = access.layer0;
        last.rectangles = rectangles;
    }
    const std::uint64_t layer = level.layer(access.layer0);
    const std::uint64_t row = layer + level.row(access.y0), column = level.column(access.x0);
    if (rectangles.are_one()) return add_line(level.line(row + column));
    const std::uint64_t rows[]{row, layer + level.row(access.y1)};
    const std::uint64_t columns[]{column, level.column(access.x1)};
    std::uint64_t last = count_ > 0 ? lines_[count_ - 1] : ~std::uint64_t{0};
    for (const std::uint64_t of_row : rows)
        for (const std::uint64_t of_column : columns) {
            const std::uint64_t line = level.line(of_row + of_column);
            if (line == last) continue;
            add_line(line);
            last = line;
        }
}

void QuadLines::add_corners(const PlacedLevel& level, const TexelAccess& access) {
    const std::array columns{level.column_offset(access.x0), level.column_offset(access.x1)};
    const std::array rows{level.row_offset(access.y0), level.row_offset(access.y1)};
    for (unsigned corner = 0; corner < 8; ++corner) {
        if (corner & ~unsigned{access.linear}) continue; // Texels that this filter does not read.
        const std::uint16_t x = corner & 1 ? access.x1 : access.x0;
        const std::uint16_t y = corner & 2 ? access.y1 : access.y0;
        const std::uint16_t layer = corner & 4 ? access.layer1 : access.layer0;
        if (x == Border || y == Border || layer == Border) {
            ++border_reads_;
            continue;
        }
        ++reads_;
        const std::uint64_t at =
            level.layer_address(layer) + columns[corner & 1] + rows[corner >> 1 & 1];
        add_line(level.expansion_log2 == 0 ? quotient(at, line_bytes_)
                                           : level.line(x, y, layer, line_bytes_));
    }
}

} // namespace ffgpu::work
