// LevelLines: the line numbers of a level's texels, of one line size, with the shifts of its layout
// worked out once: what PlacedLevel::line tells of levels that are not expanded, in a few steps.

#pragma once

#include "model/work/address_map.h"

#include <bit>
#include <cstdint>

namespace ffgpu::work {

class LevelLines {
public:
    LevelLines(const PlacedLevel& level, std::uint32_t line_bytes)
        : base_(level.base)
        , layer_bytes_(level.layer_bytes)
        , line_shift_(shift(line_bytes))
        , columns_(columns_of(level))
        , rows_(rows_of(level)) {}

    std::uint64_t layer(std::uint32_t layer) const { return base_ + layer * layer_bytes_; }
    std::uint64_t column(std::uint32_t x) const { return columns_.offset(x); }
    std::uint64_t row(std::uint32_t y) const { return rows_.offset(y); }
    // Of a texel whose address these three add up to.
    std::uint64_t line(std::uint64_t address) const { return address >> line_shift_; }

private:
    // Elements of an axis lie in blocks, those in superblocks; a layout without one of them has
    // blocks of one element, or one superblock.
    struct Axis {
        unsigned texels = 0, block = 0, superblock = 31;             // as powers of two
        std::uint64_t in_block = 0, of_block = 0, of_superblock = 0; // bytes from one to the next

        std::uint64_t offset(std::uint32_t texel) const {
            const std::uint32_t element = texel >> texels;
            const std::uint32_t inside = element & ((1u << superblock) - 1);
            return (element >> superblock) * of_superblock + (inside >> block) * of_block +
                   (inside & ((1u << block) - 1)) * in_block;
        }
    };

    static unsigned shift(std::uint32_t power_of_two) {
        return static_cast<unsigned>(std::countr_zero(power_of_two));
    }
    static std::uint64_t padded(std::uint64_t size, std::uint64_t grain) {
        return (size + grain - 1) / grain * grain;
    }
    static Axis columns_of(const PlacedLevel& level) {
        const ImageLayout& layout = level.layout;
        const std::uint64_t bytes = layout.element_bytes, block = layout.block;
        Axis axis{.texels = shift(level.block_width), .in_block = bytes, .of_block = bytes};
        if (layout.kind == Layout::Linear) return axis;
        axis.block = shift(layout.block);
        axis.of_block = bytes * block * block;
        if (layout.kind == Layout::Blocked) return axis;
        axis.superblock = shift(layout.superblock);
        axis.of_superblock = bytes * layout.superblock * layout.superblock;
        return axis;
    }
    static Axis rows_of(const PlacedLevel& level) {
        const ImageLayout& layout = level.layout;
        const std::uint64_t bytes = layout.element_bytes, block = layout.block;
        Axis axis{.texels = shift(level.block_height), .of_block = bytes * layout.width};
        if (layout.kind == Layout::Linear) return axis;
        axis.block = shift(layout.block);
        axis.in_block = bytes * block;
        axis.of_block = bytes * block * padded(layout.width, block);
        if (layout.kind == Layout::Blocked) return axis;
        axis.superblock = shift(layout.superblock);
        axis.of_block = bytes * block * layout.superblock;
        axis.of_superblock = bytes * layout.superblock * padded(layout.width, layout.superblock);
        return axis;
    }

    std::uint64_t base_, layer_bytes_;
    unsigned line_shift_;
    Axis columns_, rows_;
};

} // namespace ffgpu::work
