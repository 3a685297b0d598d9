// Rows of eight pixels of 32 bits: four quads of a batch that stand side by side have two of them.
// The vector form of QuadSurface's load_row() and store_row() (quad_access.cpp), for a whole batch.

#pragma once

#include "model/packets/fragment_batch.h"

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace ffgpu {

// Where a surface of 32-bit pixels lies, so that its rows can be addressed.
template <class Byte>
struct PixelRows {
    Byte* base = nullptr;
    std::size_t stride = 0; // bytes

    // The lower row of quad q.
    Byte* of_quad(const FragmentBatch& batch, unsigned q) const {
        return base + batch.y[q] * stride + batch.x[q] * sizeof(std::uint32_t);
    }
};

constexpr unsigned RowQuads = 4; // that are moved together

// Quads q .. q + 3 stand side by side.
inline bool is_row(const FragmentBatch& batch, unsigned q) {
    std::uint64_t x, y;
    std::memcpy(&x, batch.x.data() + q, sizeof x);
    std::memcpy(&y, batch.y.data() + q, sizeof y);
    constexpr std::uint64_t Ones = 0x0001000100010001, Steps = 0x0006000400020000;
    return x == batch.x[q] * Ones + Steps && y == batch.y[q] * Ones;
}

// All quads of the batch, each of which lies in the surface. `pixels`: a word a fragment, in the
// order of the lanes.
void load_rows(const PixelRows<const std::byte>& from,
               const FragmentBatch& batch,
               std::uint32_t* pixels);
void store_rows(const PixelRows<std::byte>& to,
                const FragmentBatch& batch,
                const std::uint32_t* pixels);

} // namespace ffgpu
