#include "model/work/canonical_order.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

namespace ffgpu::work {
namespace {

constexpr std::size_t MostRowsOfQuad = 8; // of a primitive, for each of its quads

QuadSource source(const WorkQuad& quad, std::uint32_t batch, std::uint32_t number) {
    const std::uint32_t place = static_cast<std::uint32_t>(quad.y) << 16 | quad.x;
    return {std::uint64_t{quad.piece} << 32 | place, batch, number};
}

// Calls each(primitive, first, end) for quads of one primitive that stand side by side. Numbers
// that are counted up in memory quad by quad would each wait for the one before.
template <class Each>
void for_each_run(std::span<const WorkQuad> quads, Each&& each) {
    for (std::size_t first = 0, end = 0; first < quads.size(); first = end) {
        const std::uint32_t primitive = quads[first].primitive;
        do
            ++end;
        while (end < quads.size() && quads[end].primitive == primitive);
        each(primitive, first, end);
    }
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
        for_each_run(batch->quads,
                     [&](std::uint32_t primitive, std::size_t first, std::size_t end) {
                         if (primitive + std::size_t{2} > begin_.size())
                             begin_.resize(primitive + std::size_t{2}, 0);
                         begin_[primitive + 1] += static_cast<std::uint32_t>(end - first);
                     });
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    sources_.resize(begin_.empty() ? 0 : begin_.back());
    for (std::uint32_t batch = 0; batch < batches.size(); ++batch) {
        const std::span<const WorkQuad> quads = batches[batch]->quads;
        for_each_run(quads, [&](std::uint32_t primitive, std::size_t first, std::size_t end) {
            QuadSource* to = sources_.data() + begin_[primitive];
            for (std::size_t i = first; i < end; ++i)
                *to++ = source(quads[i], batch, static_cast<std::uint32_t>(i));
            begin_[primitive] += static_cast<std::uint32_t>(end - first);
        });
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

// The host goes through a row from left to right, tile by tile: quads of a piece and row are in
// order then.
void CanonicalOrder::sort_by_rows(std::span<QuadSource> primitive) {
    std::uint32_t row = ~0u, piece = ~0u, last_row = 0, last_piece = 0;
    for (const QuadSource& source : primitive) {
        row = std::min(row, source.row());
        last_row = std::max(last_row, source.row());
        piece = std::min(piece, source.piece());
        last_piece = std::max(last_piece, source.piece());
    }
    const std::size_t rows = last_row - row + std::size_t{1};
    const std::size_t places = rows * (last_piece - piece + std::size_t{1});
    if (places > MostRowsOfQuad * primitive.size()) return;
    const auto place = [&](const QuadSource& source) {
        return (source.piece() - piece) * rows + (source.row() - row);
    };
    begin_of_rows_.assign(places + 1, 0);
    for (const QuadSource& source : primitive)
        ++begin_of_rows_[place(source) + 1];
    std::partial_sum(begin_of_rows_.begin(), begin_of_rows_.end(), begin_of_rows_.begin());
    as_they_came_.assign(primitive.begin(), primitive.end());
    for (const QuadSource& source : as_they_came_)
        primitive[begin_of_rows_[place(source)]++] = source;
}

} // namespace ffgpu::work
