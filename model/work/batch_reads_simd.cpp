// Rectangles of a plane's quads by vectors.

#include "model/base/simd_targets.h"
#include "model/work/batch_reads.h"

// Highway's order of includes.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/work/batch_reads_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace ffgpu::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using work::PlaneRectangles;
using work::RectangleBits;

// Of one quad and of two; a lane is a fragment.
using Quad = hn::CappedTag<std::uint32_t, 4>;
using TwoQuads = hn::CappedTag<std::uint32_t, 8>;
template <class Words>
using Vector = hn::Vec<Words>;
constexpr std::uint32_t All = ~std::uint32_t{0};

// In those lanes of each quad.
template <class Words>
HWY_INLINE Vector<Words> lanes(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    alignas(16) const std::array<std::uint32_t, 4> quad{a, b, c, d};
    return hn::LoadDup128(Words(), quad.data());
}

template <class Words>
HWY_INLINE Vector<Words> min_of_halves(Vector<Words> a, Vector<Words> b) {
    const hn::Repartition<std::uint16_t, Words> halves;
    return hn::BitCast(Words(), hn::Min(hn::BitCast(halves, a), hn::BitCast(halves, b)));
}

template <class Words>
HWY_INLINE Vector<Words> equal_halves(Vector<Words> a, Vector<Words> b) {
    const hn::Repartition<std::uint16_t, Words> halves;
    return hn::BitCast(
        Words(), hn::VecFromMask(halves, hn::Eq(hn::BitCast(halves, a), hn::BitCast(halves, b))));
}

// Of a quad's lanes, in all of them.
template <class Words, class Min>
HWY_INLINE Vector<Words> least_of_quad(Vector<Words> v, Min&& min) {
    v = min(v, hn::Shuffle1032(v));
    return min(v, hn::Shuffle2301(v));
}

// Where two texels of each fragment lie along one axis.
template <class Words>
struct Sides {
    Vector<Words> least;  // of the quad, in both halves
    Vector<Words> sides;  // bit 0: in the rectangle there; bit 1: in the next
    Vector<Words> others; // not 0: elsewhere, or not in this order
};

template <class Words>
HWY_INLINE Sides<Words> sides_of(Vector<Words> texels, std::uint16_t bits, hn::Mask<Words> live) {
    const Words words;
    const auto at = hn::And(texels, hn::Set(words, bits * 0x10001u));
    auto least = hn::IfThenElse(live, at, hn::Set(words, All));
    least = least_of_quad<Words>(least, min_of_halves<Words>);
    least =
        min_of_halves<Words>(least, hn::Or(hn::ShiftLeft<16>(least), hn::ShiftRight<16>(least)));
    const std::uint16_t step = static_cast<std::uint16_t>(-bits);
    const hn::Repartition<std::uint16_t, Words> halves;
    const auto on =
        hn::BitCast(words, hn::Sub(hn::BitCast(halves, at), hn::BitCast(halves, least)));
    const auto here = equal_halves<Words>(on, hn::Zero(words));
    const auto next = equal_halves<Words>(on, hn::Set(words, step * 0x10001u));
    const auto next_of_second = hn::ShiftRight<16>(next);
    const auto border = hn::And(texels, hn::Set(words, 0x80008000u));
    const auto backwards = hn::And(hn::AndNot(next_of_second, next), hn::Set(words, 1u));
    return {least,
            hn::Or(hn::And(here, hn::Set(words, 1u)), hn::And(next_of_second, hn::Set(words, 2u))),
            hn::Or(hn::Or(border, backwards), hn::Xor(hn::Or(here, next), hn::Set(words, All)))};
}

// What is not that of its quad's other live lanes: not 0.
template <class Words>
HWY_INLINE Vector<Words> differs(Vector<Words> v, hn::Mask<Words> live) {
    const auto least =
        least_of_quad<Words>(hn::IfThenElse(live, v, hn::Set(Words(), All)),
                             [](Vector<Words> a, Vector<Words> b) { return hn::Min(a, b); });
    return hn::Xor(v, least);
}

// Of the bits that no lane before has in its quad.
template <class Words>
HWY_INLINE Vector<Words> first_ones(Vector<Words> bits) {
    const auto one = hn::And(hn::Shuffle2103(bits), lanes<Words>(0, All, All, All));
    const auto two = hn::And(hn::Shuffle1032(bits), lanes<Words>(0, 0, All, All));
    const auto three = hn::And(hn::Shuffle0321(bits), lanes<Words>(0, 0, 0, All));
    return hn::AndNot(hn::Or(hn::Or(one, two), three), bits);
}

// Of one vector of fragments, where a bit of `live_bits` is set.
template <class Words>
HWY_INLINE void find_at(const AccessPlane& plane,
                        unsigned at,
                        std::uint32_t live_bits,
                        const RectangleBits& bits,
                        PlaneRectangles& found) {
    const Words words;
    const hn::Rebind<std::uint16_t, Words> heads;
    const auto own_bit = hn::Shl(hn::Set(words, 1u), hn::Iota(words, 0));
    const auto live = hn::TestBit(hn::Set(words, live_bits), own_bit);
    const Sides<Words> x =
        sides_of<Words>(hn::LoadU(words, plane.words(AccessPlane::Words::X) + at), bits.x, live);
    const Sides<Words> y =
        sides_of<Words>(hn::LoadU(words, plane.words(AccessPlane::Words::Y) + at), bits.y, live);
    auto others = hn::Or(x.others, y.others);
    const auto head = hn::PromoteTo(words, hn::LoadU(heads, plane.heads() + at));
    others = hn::Or(others, differs<Words>(head, live));
    if (plane.has_layers()) {
        const auto layers = hn::LoadU(words, plane.words(AccessPlane::Words::Layers) + at);
        others = hn::Or(others, differs<Words>(layers, live));
    }
    const auto lower = hn::TestBit(y.sides, hn::Set(words, 1u));
    const auto upper = hn::TestBit(y.sides, hn::Set(words, 2u));
    const auto read = hn::Or(hn::IfThenElseZero(lower, x.sides),
                             hn::IfThenElseZero(upper, hn::ShiftLeft<2>(x.sides)));
    const auto first = first_ones<Words>(hn::IfThenElseZero(live, read));
    const auto is_other = hn::And(live, hn::Ne(others, hn::Zero(words)));
    const auto marked = hn::IfThenElse(is_other, hn::Set(words, PlaneRectangles::Others), first);
    const hn::RebindToSigned<Words> numbers;
    hn::StoreU(hn::DemoteTo(heads, hn::BitCast(numbers, marked)), heads, found.first.data() + at);
    hn::Store(x.least, words, found.x.data() + at);
    hn::Store(y.least, words, found.y.data() + at);
}

// A plane has room for all quads up to the last that has live lanes.
void find_rectangles_lanes(const AccessPlane& plane,
                           const FragmentMask& live,
                           const RectangleBits& bits,
                           PlaneRectangles& found) {
    constexpr unsigned Step = hn::MaxLanes(TwoQuads());
    for (unsigned at = 0; at < BatchFragments; at += Step) {
        const auto of_two = static_cast<std::uint32_t>(live.words[at / 64] >> at % 64) & 0xff;
        if (Step == 8 && of_two > 0xf)
            find_at<TwoQuads>(plane, at, of_two, bits, found);
        else if ((of_two & 0xf) != 0)
            find_at<Quad>(plane, at, of_two & 0xf, bits, found);
    }
}

} // namespace
} // namespace ffgpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ffgpu::work {
namespace {
HWY_EXPORT(find_rectangles_lanes);
} // namespace

void find_rectangles(const AccessPlane& plane,
                     const FragmentMask& live,
                     const RectangleBits& bits,
                     PlaneRectangles& found) {
    HWY_DYNAMIC_DISPATCH(find_rectangles_lanes)(plane, live, bits, found);
}

} // namespace ffgpu::work
#endif
