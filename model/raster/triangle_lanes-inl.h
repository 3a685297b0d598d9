// The corners, boxes and edges of a group of triangles, a lane a triangle. Included once for each
// instruction set.

#if defined(FFGPU_MODEL_RASTER_TRIANGLE_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FFGPU_MODEL_RASTER_TRIANGLE_LANES_INL_H
#undef FFGPU_MODEL_RASTER_TRIANGLE_LANES_INL_H
#else
#define FFGPU_MODEL_RASTER_TRIANGLE_LANES_INL_H
#endif

#include "model/raster/triangle_group.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include <hwy/highway.h>
// clang-format off: after highway.h
#include "model/arith/lanes/mask_bits-inl.h"
#include "model/raster/attribute_lanes-inl.h"
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace ffgpu::HWY_NAMESPACE {
namespace {

using Narrow = hn::Rebind<std::uint32_t, Doubles>;
using NarrowIntegers = hn::Rebind<std::int32_t, Doubles>;
using Singles = hn::Rebind<float, Doubles>;
using VN = hn::Vec<Narrow>;

constexpr unsigned Size = TriangleGroup::Size;
constexpr unsigned MaxPairs = (MaxInterpolants - 1 + 3) / 4 * 2;
constexpr double PerPixel = 1.0 / (1 << SubPixelBits);

// What the vertices of a group hold, two numbers of 32 bits in each word.
struct VertexPairs {
    template <class T>
    using EachVertex = std::array<T, 3>;
    using Lanes = std::array<std::uint64_t, Size>;

    alignas(64) EachVertex<Lanes> place; // x, y
    alignas(64) EachVertex<Lanes> depth; // depth, 1 / w
    alignas(64) std::array<EachVertex<Lanes>, MaxPairs> attributes;
};

// 16 bytes of each second vertex, one behind the other.
template <class D>
HWY_INLINE hn::Vec<D> each_second(D d, const std::byte* const* vertices, std::size_t offset) {
    if constexpr (hn::MaxLanes(d) == 2) {
        return hn::LoadU(d, reinterpret_cast<const std::uint64_t*>(vertices[0] + offset));
    } else {
        const hn::Half<D> half;
        return hn::Combine(d,
                           each_second(half, vertices + hn::MaxLanes(half), offset),
                           each_second(half, vertices, offset));
    }
}

// Two words of each vertex of a vector, the first of all and the second of all. By whole vectors:
// words written one by one could not be read as vectors before they have reached the cache.
HWY_INLINE void collect_words(const std::byte* const* vertices,
                              std::size_t offset,
                              std::uint64_t* first,
                              std::uint64_t* second) {
    const Words d;
    const VW even = each_second(d, vertices, offset), odd = each_second(d, vertices + 1, offset);
    hn::Store(hn::InterleaveLower(d, even, odd), d, first);
    hn::Store(hn::InterleaveUpper(d, even, odd), d, second);
}

// Lanes behind the last triangle repeat it.
void collect(std::span<const Primitive> triangles, unsigned attributes, VertexPairs& out) {
    constexpr std::size_t Place = offsetof(WindowVertex, x);
    static_assert(offsetof(WindowVertex, depth) == Place + 8);
    static_assert(offsetof(WindowVertex, inverse_w) == Place + 12);
    for (unsigned j = 0; j < 3; ++j) {
        std::array<const std::byte*, Size> vertices;
        for (std::size_t lane = 0; lane < Size; ++lane)
            vertices[lane] = reinterpret_cast<const std::byte*>(
                triangles[std::min(lane, triangles.size() - 1)].vertices[j]);
        for (std::size_t lane = 0; lane < Size; lane += hn::Lanes(Words())) {
            const std::byte* const* const at = vertices.data() + lane;
            collect_words(at, Place, out.place[j].data() + lane, out.depth[j].data() + lane);
            for (unsigned i = 0; i < attributes; i += 4) // There are fewer than MaxInterpolants.
                collect_words(at,
                              offsetof(WindowVertex, attributes) + i * sizeof(float),
                              out.attributes[i / 2][j].data() + lane,
                              out.attributes[i / 2 + 1][j].data() + lane);
        }
    }
}

HWY_INLINE VW load(const VertexPairs::Lanes& lanes, std::size_t lane) {
    return hn::Load(Words(), lanes.data() + lane);
}

// The lower or the upper number of pairs.
HWY_INLINE VN half_of(VW pairs, bool upper) {
    return hn::TruncateTo(Narrow(), upper ? hn::ShiftRight<32>(pairs) : pairs);
}

HWY_INLINE VD integers_of(VN bits) {
    return hn::PromoteTo(Doubles(), hn::BitCast(NarrowIntegers(), bits));
}

HWY_INLINE VD floats_of(VN bits) {
    return hn::PromoteTo(Doubles(), hn::BitCast(Singles(), bits));
}

// Integers below 2^50 in magnitude, in two's complement.
HWY_INLINE VW words_of(VD integers) {
    return hn::Sub(bits_of(hn::Add(integers, constant(Rounder))), bits_of(constant(Rounder)));
}

// To 32-bit numbers of either sign.
template <class T>
HWY_INLINE void store_narrow(VD integers, TriangleGroup::Each<T>& to, std::size_t lane) {
    const Narrow d;
    const VN narrow = hn::TruncateTo(d, bits_of(hn::Add(integers, constant(Rounder))));
    hn::StoreU(narrow, d, reinterpret_cast<std::uint32_t*>(to.data() + lane));
}

HWY_INLINE TriangleGroup::Bits bits_from(MaskD mask, std::size_t lane) {
    return static_cast<TriangleGroup::Bits>(bits_from_mask(Doubles(), mask) << lane);
}

template <class Operation>
HWY_INLINE VD over_three(const std::array<VD, 3>& of, Operation&& operation) {
    return operation(operation(of[0], of[1]), of[2]);
}
HWY_INLINE VD least(const std::array<VD, 3>& of) {
    return over_three(of, [](VD a, VD b) HWY_ATTR { return hn::Min(a, b); });
}
HWY_INLINE VD greatest(const std::array<VD, 3>& of) {
    return over_three(of, [](VD a, VD b) HWY_ATTR { return hn::Max(a, b); });
}

struct CornerLanes {
    std::array<VD, 3> x, y;

    HWY_INLINE CornerLanes(const VertexPairs& pairs, std::size_t lane) {
        for (unsigned j = 0; j < 3; ++j) {
            const VW place = load(pairs.place[j], lane);
            x[j] = integers_of(half_of(place, false));
            y[j] = integers_of(half_of(place, true));
        }
    }
    HWY_INLINE MaskD outside_guard_band() const {
        const VD farthest =
            hn::Max(hn::Max(greatest(x), greatest(y)), hn::Neg(hn::Min(least(x), least(y))));
        return hn::Gt(farthest, constant(GuardBand << SubPixelBits));
    }
};

// Two sides, from the first vertex.
struct SideLanes {
    VD dx1, dy1, dx2, dy2, area;

    HWY_INLINE explicit SideLanes(const CornerLanes& at)
        : dx1(hn::Sub(at.x[1], at.x[0]))
        , dy1(hn::Sub(at.y[1], at.y[0]))
        , dx2(hn::Sub(at.x[2], at.x[0]))
        , dy2(hn::Sub(at.y[2], at.y[0]))
        , area(hn::Sub(hn::Mul(dx1, dy2), hn::Mul(dx2, dy1))) {}

    HWY_INLINE MaskD are_slivers() const {
        const auto longest = [](VD a, VD b) HWY_ATTR {
            return hn::Max(hn::Max(hn::Abs(a), hn::Abs(b)), hn::Abs(hn::Sub(b, a)));
        };
        return hn::Lt(hn::Abs(area), hn::Max(longest(dx1, dx2), longest(dy1, dy2)));
    }
};

struct BoxLanes {
    VD x0, y0, x1, y1;

    HWY_INLINE BoxLanes(const CornerLanes& at, const Rectangle& clip) {
        const auto first_centre = [](VD to) HWY_ATTR {
            return hn::Floor(hn::Mul(hn::Add(to, constant(127)), constant(PerPixel)));
        };
        x0 = hn::Max(first_centre(least(at.x)), constant(clip.x0));
        y0 = hn::Max(first_centre(least(at.y)), constant(clip.y0));
        x1 = hn::Min(first_centre(greatest(at.x)), constant(clip.x1));
        y1 = hn::Min(first_centre(greatest(at.y)), constant(clip.y1));
    }
    HWY_INLINE MaskD are_empty() const { return hn::Or(hn::Ge(x0, x1), hn::Ge(y0, y1)); }
    HWY_INLINE MaskD are_small() const {
        constexpr double Few = 2;
        return hn::Le(hn::Max(hn::Sub(x1, x0), hn::Sub(y1, y0)), constant(Few));
    }
    HWY_INLINE void store(TriangleGroup& group, std::size_t lane) const {
        const auto pair = [](VD low, VD high) HWY_ATTR {
            return select(0xffffffff, words_of(low), hn::ShiftLeft<32>(words_of(high)));
        };
        hn::StoreInterleaved2(pair(x0, y0),
                              pair(x1, y1),
                              Words(),
                              reinterpret_cast<std::uint64_t*>(group.box.data() + lane));
    }
};

// make_exact_edge().
struct EdgeLanes {
    VD a, b, c, fraction;

    HWY_INLINE EdgeLanes(VD px, VD py, VD qx, VD qy)
        : a(hn::Sub(py, qy))
        , b(hn::Sub(qx, px)) {
        const VD half = constant(1 << (SubPixelBits - 1)), zero = constant(0);
        const VD at_centre = hn::Add(hn::Mul(a, hn::Sub(half, px)), hn::Mul(b, hn::Sub(half, py)));
        const MaskD owns = hn::Or(hn::Gt(a, zero), hn::And(hn::Eq(a, zero), hn::Gt(b, zero)));
        const VD inside = hn::Sub(at_centre, hn::IfThenElse(owns, zero, constant(1)));
        c = hn::Floor(hn::Mul(inside, constant(PerPixel)));
        fraction = hn::Sub(inside, hn::Mul(c, constant(1 << SubPixelBits)));
    }
    HWY_INLINE VD at(VD x, VD y) const { return hn::Add(hn::Add(hn::Mul(a, x), hn::Mul(b, y)), c); }
    HWY_INLINE void store(TriangleGroup::Each<Edge>& edges, std::size_t lane) const {
        hn::StoreInterleaved2(select(0xffffffff, words_of(a), hn::ShiftLeft<32>(words_of(b))),
                              words_of(c),
                              Words(),
                              reinterpret_cast<std::uint64_t*>(edges.data() + lane));
    }
};

using ThreeEdges = std::array<EdgeLanes, 3>;

// Counter-clockwise, whichever way round the vertices stand.
HWY_INLINE ThreeEdges edges_of(const CornerLanes& at, VD area) {
    const MaskD swapped = hn::Lt(area, constant(0));
    const VD x1 = hn::IfThenElse(swapped, at.x[2], at.x[1]);
    const VD y1 = hn::IfThenElse(swapped, at.y[2], at.y[1]);
    const VD x2 = hn::IfThenElse(swapped, at.x[1], at.x[2]);
    const VD y2 = hn::IfThenElse(swapped, at.y[1], at.y[2]);
    return {EdgeLanes(at.x[0], at.y[0], x1, y1),
            EdgeLanes(x1, y1, x2, y2),
            EdgeLanes(x2, y2, at.x[0], at.y[0])};
}

// Of boxes of up to 2x2 pixels, whose pixels are their corners.
HWY_INLINE MaskD miss_their_boxes(const ThreeEdges& edges, const BoxLanes& box) {
    const VD right = hn::Sub(box.x1, constant(1)), top = hn::Sub(box.y1, constant(1));
    const auto outside = [&](VD x, VD y) HWY_ATTR {
        return hn::Min(hn::Min(edges[0].at(x, y), edges[1].at(x, y)), edges[2].at(x, y));
    };
    const VD most = hn::Max(hn::Max(outside(box.x0, box.y0), outside(right, box.y0)),
                            hn::Max(outside(box.x0, top), outside(right, top)));
    return hn::And(box.are_small(), hn::Lt(most, constant(0)));
}

} // namespace
} // namespace ffgpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
