// Where an element (a texel, a compressed block, a pixel) of an image lies in the explored
// machine's memory: linear, in blocks, or in blocks inside superblocks ("6-D blocking"), after Z.
// Hakura and A. Gupta, The Design and Analysis of a Cache Architecture for Texture Mapping, ISCA
// 1997.
//
// These are properties of the machine explored, not of the functional GPU's memory.

#pragma once

#include "model/base/powers_of_two.h"
#include "model/work/config.h"

#include <cstdint>

namespace ffgpu::work {

struct ImageLayout {
    Layout kind = Layout::Linear;
    std::uint32_t block = 4;       // elements, a power of two
    std::uint32_t superblock = 32; // elements, a power of two
    std::uint32_t width = 1;       // of the image, in elements
    std::uint32_t height = 1;
    std::uint32_t element_bytes = 4;

    // An image smaller than a block is linear, smaller than a superblock only blocked.
    static ImageLayout make(Layout wanted,
                            std::uint32_t block,
                            std::uint32_t superblock,
                            std::uint32_t width,
                            std::uint32_t height,
                            std::uint32_t element_bytes) {
        Layout kind = wanted;
        if (kind == Layout::Blocked6d && (width < superblock || height < superblock))
            kind = Layout::Blocked;
        if (kind == Layout::Blocked && (width < block || height < block)) kind = Layout::Linear;
        return {kind, block, superblock, width, height, element_bytes};
    }

    // Bytes of one layer, blocks at the right and upper edge padded.
    std::uint64_t bytes() const {
        const std::uint32_t grain = kind == Layout::Linear    ? 1
                                    : kind == Layout::Blocked ? block
                                                              : superblock;
        return std::uint64_t{padded(width, grain)} * padded(height, grain) * element_bytes;
    }

    // Byte offset of element (x, y) in its layer: a part of the column, and one of the row.
    std::uint64_t offset(std::uint32_t x, std::uint32_t y) const {
        return column_offset(x) + row_offset(y);
    }
    std::uint64_t column_offset(std::uint32_t x) const {
        switch (kind) {
        case Layout::Linear:
            break;
        case Layout::Blocked:
            return element_bytes * column_in_blocks(x, block);
        case Layout::Blocked6d:
            return element_bytes *
                   (std::uint64_t{quotient(x, superblock)} * superblock * superblock +
                    column_in_blocks(remainder(x, superblock), block));
        }
        return std::uint64_t{element_bytes} * x;
    }
    std::uint64_t row_offset(std::uint32_t y) const {
        switch (kind) {
        case Layout::Linear:
            break;
        case Layout::Blocked:
            return element_bytes * row_in_blocks(y, block, padded(width, block));
        case Layout::Blocked6d:
            return element_bytes * (std::uint64_t{quotient(y, superblock)} * superblock *
                                        padded(width, superblock) +
                                    row_in_blocks(remainder(y, superblock), block, superblock));
        }
        return std::uint64_t{element_bytes} * y * width;
    }

    // Whether (x + 1, y) lies beside (x, y), and (x, y + 1) `row_step()` bytes behind it: in a
    // block where x and y are even.
    bool has_square_at(std::uint32_t x, std::uint32_t y) const {
        return kind == Layout::Linear || (block > 1 && remainder(x | y, 2) == 0);
    }
    std::uint64_t row_step() const {
        return std::uint64_t{element_bytes} * (kind == Layout::Linear ? width : block);
    }

    // Elements of a row from x on that lie side by side.
    std::uint32_t run(std::uint32_t x) const {
        return kind == Layout::Linear ? width - x : block - remainder(x, block);
    }

private:
    static std::uint32_t padded(std::uint32_t size, std::uint32_t grain) {
        return (size + grain - 1) & ~(grain - 1);
    }

    // Element number in blocks of b x b in row order, row order inside, of an image `w` wide: what
    // the column and the row add to it.
    static std::uint64_t column_in_blocks(std::uint32_t x, std::uint32_t b) {
        return std::uint64_t{quotient(x, b)} * b * b + remainder(x, b);
    }
    static std::uint64_t row_in_blocks(std::uint32_t y, std::uint32_t b, std::uint32_t w) {
        return std::uint64_t{quotient(y, b)} * b * w + remainder(y, b) * b;
    }
};

} // namespace ffgpu::work
