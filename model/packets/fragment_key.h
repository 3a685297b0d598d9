// The name of a fragment, or of a sample of one: (draw, primitive, sequence). The model, a second
// backend and an RTL pipe give a fragment the same name without knowing of each other, so that the
// first difference between two of them can be told.
//
// draw and primitive are PrimitiveKey's. The sequence says which fragment of the primitive it is:
//
//     bits 63..32  piece: what a primitive becomes may be several triangles, lines or points, by
//                  clipping, for its outline, or because it has more than three corners; counted
//                  from 0 in the order in which they come to set-up. An image is a piece; where
//                  several of its pixels touch one quad, the n-th of them is piece n.
//     bits 29..17  quad row, from the bottom
//     bits 16..4   quad column
//     bits  3..2   lane in the quad: (0, 0), (1, 0), (0, 1), (1, 1)
//     bits  1..0   sample; 0 where targets have one
//
// So sequences count in the order of pieces, then rows, then columns, then lanes, then samples: the
// canonical order, in which a WholeCommand holds its quads. A machine's own order is another.

#pragma once

#include "model/packets/work_stream.h"

#include <compare>
#include <cstdint>

namespace ffgpu {

struct FragmentKey {
    std::uint32_t draw = 0;
    std::uint32_t primitive = 0;
    std::uint64_t sequence = 0;

    // NOLINTNEXTLINE(modernize-use-nullptr): a false alarm of clang-tidy 14.
    auto operator<=>(const FragmentKey&) const = default;
};

// Of a quad: anything with a piece and the window pixel (x, y) of its lane 0.
template <class Quad>
constexpr std::uint64_t fragment_sequence(const Quad& quad, unsigned lane, unsigned sample = 0) {
    const std::uint64_t row = quad.y / 2u, column = quad.x / 2u;
    return std::uint64_t{quad.piece} << 32 | row << 17 | column << 4 | lane << 2 | sample;
}

// Of quads of one draw: those of equal order are one quad.
constexpr bool comes_before(const WorkQuad& a, const WorkQuad& b) {
    if (a.primitive != b.primitive) return a.primitive < b.primitive;
    return fragment_sequence(a, 0) < fragment_sequence(b, 0);
}

} // namespace ffgpu
