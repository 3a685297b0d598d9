#include "model/work/canonical_order.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

namespace ffgpu::work {
namespace {

QuadSource source(const WorkQuad& quad, std::uint32_t batch, std::uint32_t number) {
    const std::uint32_t place = static_cast<std::uint32_t>(quad.y) << 16 | quad.x;
    return {std::uint64_t{quad.piece} << 32 | place, batch, number};
}

void number_image_pieces(std::span<QuadSource> sources) {
    constexpr std::uint64_t OnePiece = std::uint64_t{1} << 32;
    for (std::size_t i = 1; i < sources.size(); ++i)
        if ((sources[i].piece_and_place - sources[i - 1].piece_and_place) % OnePiece == 0)
            sources[i].piece_and_place = sources[i - 1].piece_and_place + OnePiece;
}

} // namespace

bool QuadSource::operator<(const QuadSource& other) const {
    if (piece_and_place != other.piece_and_place) return piece_and_place < other.piece_and_place;
    return std::pair(batch, quad) < std::pair(other.batch, other.quad);
}

// By primitives at first, whose numbers are small: each has few quads then.
std::span<const QuadSource> CanonicalOrder::of(std::span<const WorkBatch* const> batches,
                                               bool is_image) {
    begin_.clear();
    for (const WorkBatch* const batch : batches)
        for (const WorkQuad& quad : batch->quads) {
            if (quad.primitive + std::size_t{2} > begin_.size())
                begin_.resize(quad.primitive + std::size_t{2}, 0);
            ++begin_[quad.primitive + 1];
        }
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    sources_.resize(begin_.empty() ? 0 : begin_.back());
    for (std::uint32_t batch = 0; batch < batches.size(); ++batch) {
        std::uint32_t number = 0;
        for (const WorkQuad& quad : batches[batch]->quads)
            sources_[begin_[quad.primitive]++] = source(quad, batch, number++);
    }
    std::uint32_t first = 0;
    for (const std::uint32_t end : begin_) {
        sort(std::span(sources_).subspan(first, end - first));
        first = end;
    }
    if (is_image) {
        number_image_pieces(sources_);
        std::sort(sources_.begin(), sources_.end());
    }
    return sources_;
}

void CanonicalOrder::sort(std::span<QuadSource> primitive) {
    constexpr std::size_t Few = 8; // Then rows do not pay.
    if (std::is_sorted(primitive.begin(), primitive.end())) return;
    if (primitive.size() > Few) sort_by_rows(primitive);
    if (!std::is_sorted(primitive.begin(), primitive.end()))
        std::sort(primitive.begin(), primitive.end());
}

// The host goes through a row from left to right, tile by tile: quads of one piece are in order
// then.
void CanonicalOrder::sort_by_rows(std::span<QuadSource> primitive) {
    std::uint32_t lowest = primitive[0].row(), highest = lowest;
    for (const QuadSource& source : primitive) {
        lowest = std::min(lowest, source.row());
        highest = std::max(highest, source.row());
    }
    row_begin_.assign(highest - lowest + std::size_t{2}, 0);
    for (const QuadSource& source : primitive)
        ++row_begin_[source.row() - lowest + 1];
    std::partial_sum(row_begin_.begin(), row_begin_.end(), row_begin_.begin());
    rest_.assign(primitive.begin(), primitive.end());
    for (const QuadSource& source : rest_)
        primitive[row_begin_[source.row() - lowest]++] = source;
}

} // namespace ffgpu::work
