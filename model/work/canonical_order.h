// CanonicalOrder: the quads of a draw in the order of their keys (model/packets/fragment_key.h),
// whatever order the host drew them in. It keeps its memory from draw to draw.

#pragma once

#include "model/packets/work_stream.h"

#include <cstdint>
#include <span>
#include <vector>

namespace ffgpu::work {

// A quad of a batch, by what brings it into the canonical order within its primitive.
struct QuadSource {
    std::uint64_t piece_and_place = 0; // piece, row, column
    std::uint32_t batch = 0;
    std::uint32_t quad = 0;

    std::uint32_t piece() const { return static_cast<std::uint32_t>(piece_and_place >> 32); }
    std::uint32_t row() const { return static_cast<std::uint32_t>(piece_and_place) >> 16; }

    // Quads of one place stay in the order in which they came.
    bool operator<(const QuadSource& other) const;
};

class CanonicalOrder {
public:
    // Valid up to the next call. The quads of one place of an image, each drawn by another of its
    // pixels, are told as pieces.
    std::span<const QuadSource> of(std::span<const WorkBatch* const> batches, bool is_image);

private:
    void sort(std::span<QuadSource> primitive);
    // Unless there are far more rows than quads.
    void sort_by_rows(std::span<QuadSource> primitive);

    std::vector<QuadSource> sources_;
    std::vector<QuadSource> as_they_came_; // of a primitive
    std::vector<std::uint32_t> begin_;     // of each primitive's quads; then the end
    std::vector<std::uint32_t> begin_of_rows_;
};

} // namespace ffgpu::work
