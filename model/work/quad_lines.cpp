#include "model/work/quad_lines.h"

#include <algorithm>
#include <array>

namespace ffgpu::work {
namespace {

constexpr std::uint16_t Border = TexelAccess::BorderTexel;

// 2x2 texels of one layer, none of them the border colour's, as they lie in memory.
bool is_plain_square(const LevelLines& level, const TexelAccess& access) {
    return access.linear == 3 && level.has_tables() && access.x0 != Border && access.x1 != Border &&
           access.y0 != Border && access.y1 != Border && access.layer0 != Border;
}

// The rectangle (LevelLines) that holds a quad's lowest texels on the left, that to its right, and
// the two above them: numbers 0 to 3. Most quads read texels of these alone.
class FourRectangles {
public:
    FourRectangles(const LevelLines& level, std::span<const TexelAccesses::Place> squares)
        : first_x_(level.rectangle(0xffff))
        , first_y_(level.rectangle(0xffff0000) >> 16) {
        std::uint32_t left = ~0u, right = 0, below = ~0u, above = 0;
        for (const TexelAccesses::Place place : squares) {
            left = std::min(left, place & 0xffff);
            right = std::max(right, (place & 0xffff) + 1);
            below = std::min(below, place >> 16);
            above = std::max(above, (place >> 16) + 1);
        }
        x_ = left & first_x_;
        y_ = below & first_y_;
        columns_ = (right & first_x_) - x_;
        rows_ = (above & first_y_) - y_;
    }

    bool hold_all() const { return columns_ <= width() && rows_ <= height(); }
    bool are_one() const { return (columns_ | rows_) == 0; }
    // A texel of the rectangle.
    std::uint32_t x(unsigned number) const { return x_ + (number % 2 != 0 ? width() : 0); }
    std::uint32_t y(unsigned number) const { return y_ + (number / 2 != 0 ? height() : 0); }
    // In which ones the four texels of a square lie, in the order of the reads: two bits each.
    unsigned of_corners(TexelAccesses::Place square) const {
        const unsigned left = is_right(square & 0xffff), right = is_right((square & 0xffff) + 1);
        const unsigned below = is_above(square >> 16), above = is_above((square >> 16) + 1);
        return left | right << 2 | left << 4 | right << 6 | below << 1 | below << 3 | above << 5 |
               above << 7;
    }

private:
    std::uint32_t width() const { return 0x10000 - first_x_; }
    std::uint32_t height() const { return 0x10000 - first_y_; }
    bool is_right(std::uint32_t x) const { return (x & first_x_) != x_; }
    bool is_above(std::uint32_t y) const { return (y & first_y_) != y_; }

    std::uint32_t first_x_, first_y_; // masks
    std::uint32_t x_ = 0, y_ = 0;
    std::uint32_t columns_ = 0, rows_ = 0; // from there on, to the last one's
};

} // namespace

bool QuadLines::add_squares(const TextureLines& texture,
                            const TexelAccesses::OfQuad& quad,
                            unsigned lanes) {
    const RegularAccesses common = quad.common();
    if (!merges_ || !quad.is_regular() || common.linear != 3 || common.next_level ||
        (common.lanes & ~lanes) != 0 || common.lanes == 0 || common.level >= texture.lines.size())
        return false;
    const LevelLines& level = texture.lines[common.level];
    if (!level.has_tables()) return false;
    const FourRectangles four(level, quad.places());
    if (!four.hold_all()) return false;
    make_room(4);
    expands_blocks_ |= texture.levels[common.level].compressed;
    reads_ += 4 * static_cast<std::uint32_t>(quad.places().size());
    const std::uint64_t layer = level.layer(common.layer);
    const auto add = [&](unsigned number) {
        add_line(level.line(layer + level.row(four.y(number)) + level.column(four.x(number))));
    };
    if (four.are_one()) {
        add(0);
        return true;
    }
    unsigned added = 0;
    for (const TexelAccesses::Place place : quad.places())
        for (unsigned corners = four.of_corners(place), i = 0; i < 4; ++i, corners >>= 2) {
            if ((added >> corners % 4 & 1) != 0) continue;
            added |= 1u << corners % 4;
            add(corners % 4);
        }
    return true;
}

void QuadLines::add_other(const TextureLines& texture, const TexelAccess& access) {
    make_room(MostOfAccess);
    const PlacedLevel& level = texture.levels[access.level];
    const LevelLines& lines = texture.lines[access.level];
    expands_blocks_ |= level.compressed && level.expansion_log2 == 0;
    if (is_plain_square(lines, access)) // Most are.
        add_square(lines, access);
    else
        add_corners(level, access);
}

void QuadLines::add_line(std::uint64_t line) {
    std::uint64_t* const end = lines_.data() + count_;
    std::uint64_t* begin = lines_.data();
    if (!merges_ && count_ > 0) begin = end - 1;
    if (std::find(begin, end, line) != end) return;
    *end = line;
    ++count_;
}

// Most accesses fall on the line of the texel before.
void QuadLines::add_square(const LevelLines& level, const TexelAccess& access) {
    const std::uint64_t layer = level.layer(access.layer0);
    const std::uint64_t rows[]{layer + level.row(access.y0), layer + level.row(access.y1)};
    const std::uint64_t columns[]{level.column(access.x0), level.column(access.x1)};
    reads_ += 4;
    const LevelLines::Rectangles rectangles = level.rectangles(access);
    if (rectangles.are_one()) {
        add_line(level.line(rows[0] + columns[0]));
        if (merges_) last_[access.level & 1] = {&level, access.layer0, rectangles};
        return;
    }
    std::uint64_t last = count_ > 0 ? lines_[count_ - 1] : ~std::uint64_t{0};
    for (const std::uint64_t row : rows)
        for (const std::uint64_t column : columns) {
            const std::uint64_t line = level.line(row + column);
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
        if (x == Border || y == Border || layer == Border) continue;
        ++reads_;
        const std::uint64_t at =
            level.layer_address(layer) + columns[corner & 1] + rows[corner >> 1 & 1];
        add_line(level.expansion_log2 == 0 ? quotient(at, line_bytes_)
                                           : level.line(x, y, layer, line_bytes_));
    }
}

} // namespace ffgpu::work
