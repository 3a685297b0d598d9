// LevelLines: the line numbers of a level's texels, of one line size, from a table for its columns
// and one for its rows: what PlacedLevel::line tells, in a few steps.

#pragma once

#include "model/packets/texel_footprint.h"
#include "model/work/placed_level.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ffgpu::work {

// Bits of a texel's coordinates.
struct RectangleBits {
    std::uint16_t x = 0, y = 0;
};

class LevelLines {
public:
    LevelLines(const PlacedLevel& level, std::uint32_t line_bytes);

    // Levels that are expanded, or take 4 GB, have no tables: PlacedLevel tells their lines.
    bool has_tables() const { return !columns_.empty(); }

    std::uint64_t layer(std::uint32_t layer) const { return base_ + layer * layer_bytes_; }
    // Beyond the level's edges they tell of texels inside.
    std::uint64_t column(std::uint32_t x) const { return columns_[x & column_mask_]; }
    std::uint64_t row(std::uint32_t y) const { return rows_[y & row_mask_]; }
    // Powers of two.
    std::size_t columns() const { return columns_.size(); }
    std::size_t rows() const { return rows_.size(); }
    // Of a texel whose address these three add up to.
    std::uint64_t line(std::uint64_t address) const { return address >> line_shift_; }

    // In which rectangles of texels an access' four corners lie: those of one layer in the same
    // rectangle are of one line. Rectangles are 2^n texels wide and high, the largest that lie on
    // one line each; one texel, where lines hold no rectangles.
    struct Rectangles {
        std::uint16_t x0 = 0, x1 = 0, y0 = 0, y1 = 0; // of their first texels

        bool are_one() const { return x0 == x1 && y0 == y1; }
        bool operator==(const Rectangles& other) const {
            return std::bit_cast<std::uint64_t>(*this) == std::bit_cast<std::uint64_t>(other);
        }
    };
    Rectangles rectangles(const TexelAccess& access) const {
        const Rectangles texels{access.x0, access.x1, access.y0, access.y1};
        return inside(std::bit_cast<std::uint64_t>(texels));
    }
    Rectangles rectangles(const AccessPlane::AccessWords& access) const {
        return inside(access[1] | std::uint64_t{access[2]} << 32);
    }

    // Texels that differ in others of their bits alone are in one rectangle.
    RectangleBits rectangle_bits() const { return {firsts_.x0, firsts_.y0}; }
    bool has_rectangles() const { return (firsts_.x0 & firsts_.y0) != 0xffff; }
    // Texels that do so in others than `bits` alone are, too.
    bool has_rectangles_of(const RectangleBits& bits) const {
        return ((firsts_.x0 & ~bits.x) | (firsts_.y0 & ~bits.y)) == 0;
    }

private:
    // Those of texels as Rectangles has them.
    Rectangles inside(std::uint64_t texels) const {
        return std::bit_cast<Rectangles>(texels & std::bit_cast<std::uint64_t>(firsts_));
    }
    void find_rectangles();

    std::uint64_t base_, layer_bytes_;
    unsigned line_shift_;
    std::uint32_t column_mask_ = 0, row_mask_ = 0;
    std::vector<std::uint32_t> columns_, rows_;         // bytes; powers of two many
    Rectangles firsts_{0xffff, 0xffff, 0xffff, 0xffff}; // masks
};

// The levels of a texture, and their lines.
struct TextureLines {
    std::vector<PlacedLevel> levels;
    std::vector<LevelLines> lines;
    RectangleBits bits; // of rectangles, in all levels that have larger ones than texels
    std::uint32_t in_rectangles = 0; // levels whose texels lie in those, by tables: a bit each

    void add(const PlacedLevel& level, std::uint32_t line_bytes) {
        levels.push_back(level);
        lines.emplace_back(level, line_bytes);
        add_bits();
    }
    void set(std::size_t number, const PlacedLevel& level, std::uint32_t line_bytes) {
        levels[number] = level;
        lines[number] = LevelLines(level, line_bytes);
        add_bits();
    }

private:
    void add_bits() {
        bits = {};
        for (const LevelLines& level : lines) {
            if (!level.has_rectangles()) continue;
            bits.x |= level.rectangle_bits().x;
            bits.y |= level.rectangle_bits().y;
        }
        in_rectangles = 0;
        for (std::size_t i = 0; i < std::min<std::size_t>(lines.size(), 32); ++i)
            if (lines[i].has_tables() && lines[i].has_rectangles_of(bits))
                in_rectangles |= std::uint32_t{1} << i;
    }
};

} // namespace ffgpu::work
