// TraversalKeys: traversal_key() from two tables. In all orders but Hilbert's a key is made of bits
// of the row, and others of the column.

#pragma once

#include "model/work/traversal.h"

#include <vector>

namespace ffgpu::work {

class TraversalKeys {
public:
    explicit TraversalKeys(const RasterOrder& raster)
        : raster_(raster) {
        if (raster.traversal == Traversal::Hilbert) return;
        for (std::uint32_t quad = 0; quad < Quads; ++quad) {
            rows_.push_back(traversal_key(raster, 0, 2 * quad));
            columns_.push_back(traversal_key(raster, 2 * quad, 0));
        }
    }

    // Of pixel (x, y), both below 2^(QuadBits + 1).
    std::uint32_t operator()(std::uint32_t x, std::uint32_t y) const {
        if (rows_.empty()) return traversal_key(raster_, x, y);
        return rows_[y / 2] | columns_[x / 2];
    }

private:
    static constexpr std::uint32_t Quads = 1u << QuadBits;

    RasterOrder raster_;
    std::vector<std::uint32_t> rows_, columns_; // of a row's first quad, of a column's
};

} // namespace ffgpu::work
