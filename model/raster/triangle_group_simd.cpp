// The fast form of set_up_triangles(): the numbers of set_up(), a lane a triangle, in binary64,
// where all that are integers are exact. What follows from a division and is rounded is computed in
// the same order of operations.

#include "model/raster/simd_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/raster/triangle_group_simd.cpp"

#include "model/raster/triangle_group.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>

#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// clang-format off: after foreach_target.h
#include "model/arith/lanes/mask_bits-inl.h"
#include "model/raster/attribute_lanes-inl.h"
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace ffgpu {
namespace HWY_NAMESPACE {
namespace {

using Narrow = hn::Rebind<std::uint32_t, Doubles>;
using NarrowIntegers = hn::Rebind<std::int32_t, Doubles>;
using Singles = hn::Rebind<float, Doubles>;
using VN = hn::Vec<Narrow>;

constexpr unsigned Size = TriangleGroup::Size;
constexpr unsigned MaxPairs = (MaxInterpolants + 1) / 2;
constexpr double PerPixel = 1.0 / (1 << SubPixelBits);
constexpr double DepthOne = std::int64_t{1} << DepthPlane::FractionBits;

// What the vertices of a group hold, two numbers of 32 bits in each word.
struct VertexPairs {
    template <class T>
    using EachVertex = std::array<T, 3>;
    using Lanes = std::array<std::uint64_t, Size>;

    alignas(64) EachVertex<Lanes> place; // x, y
    alignas(64) EachVertex<Lanes> depth; // depth, 1 / w
    alignas(64) std::array<EachVertex<Lanes>, MaxPairs> attributes;
};

std::uint64_t pair_at(const WindowVertex& vertex, std::size_t offset) {
    std::uint64_t pair;
    std::memcpy(&pair, reinterpret_cast<const std::byte*>(&vertex) + offset, sizeof pair);
    return pair;
}

// Lanes behind the last triangle repeat it.
void collect(std::span<const Primitive> triangles, unsigned pairs, VertexPairs& out) {
    for (unsigned lane = 0; lane < Size; ++lane) {
        const Primitive& triangle = triangles[std::min<std::size_t>(lane, triangles.size() - 1)];
        for (unsigned j = 0; j < 3; ++j) {
            const WindowVertex& vertex = *triangle.vertices[j];
            out.place[j][lane] = pair_at(vertex, offsetof(WindowVertex, x));
            out.depth[j][lane] = pair_at(vertex, offsetof(WindowVertex, depth));
            for (unsigned i = 0; i < pairs; ++i)
                out.attributes[i][j][lane] =
                    pair_at(vertex, offsetof(WindowVertex, attributes) + i * sizeof(std::uint64_t));
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

// PlaneBasis and what else the planes share.
struct BasisLanes {
    VD per_divisor;
    FrameLanes frame;

    HWY_INLINE BasisLanes(const CornerLanes& at, const SideLanes& sides)
        : per_divisor(hn::Div(constant(1 << SubPixelBits), hn::Abs(sides.area))) {
        const VD sign = hn::CopySign(constant(1), sides.area), minus = hn::Neg(sign);
        const auto offset = [](VD place) HWY_ATTR {
            const VD whole = hn::Floor(hn::Mul(place, constant(PerPixel)));
            const VD inside = hn::Sub(place, hn::Mul(whole, constant(1 << SubPixelBits)));
            return hn::Sub(constant(1 << (SubPixelBits - 1)), inside);
        };
        constexpr int Reach = AttributeFrame{}.reach;
        frame = {.x1 = hn::Mul(sign, sides.dy2),
                 .x2 = hn::Mul(minus, sides.dy1),
                 .y1 = hn::Mul(minus, sides.dx2),
                 .y2 = hn::Mul(sign, sides.dx1),
                 .factor = hn::Mul(per_divisor, constant(ExactQuotient::factor(1))),
                 .offset_x = offset(at.x[0]),
                 .offset_y = offset(at.y[0]),
                 .reach = FrameLanes::reach_of(Reach)};
    }
};

// Depth planes; returns the lanes that are too steep for them.
HWY_INLINE MaskD set_up_depth(const std::array<VD, 3>& depths,
                              std::uint32_t depth_scale,
                              const BasisLanes& basis,
                              TriangleGroup& group,
                              std::size_t lane) {
    constexpr double Steepest = std::int64_t{1} << 42; // Products with offsets stay exact.
    std::array<VD, 3> z;
    for (unsigned j = 0; j < 3; ++j) {
        const VD clamped =
            hn::IfThenElseZero(hn::Gt(depths[j], constant(0)), hn::Min(depths[j], constant(1)));
        const VD scaled = hn::Mul(clamped, constant(DepthOne * depth_scale));
        z[j] = hn::Floor(hn::Add(scaled, constant(0.5)));
    }
    const FrameLanes& f = basis.frame;
    const VD e1 = hn::Sub(z[1], z[0]), e2 = hn::Sub(z[2], z[0]), by = basis.per_divisor;
    const auto step = [&](VD first, VD second) HWY_ATTR {
        return hn::Add(hn::Mul(e1, hn::Mul(first, by)), hn::Mul(e2, hn::Mul(second, by)));
    };
    const auto rounded = [](VD value) HWY_ATTR {
        return hn::Trunc(hn::Add(value, hn::CopySign(constant(0.5), value)));
    };
    const VD exact_dx = step(f.x1, f.x2), exact_dy = step(f.y1, f.y2);
    const VD dx = rounded(exact_dx), dy = rounded(exact_dy);
    const VD way = hn::Add(hn::Add(hn::Mul(dx, f.offset_x), hn::Mul(dy, f.offset_y)),
                           constant(1 << (SubPixelBits - 1)));
    const VD origin = hn::Add(z[0], hn::Floor(hn::Mul(way, constant(PerPixel))));
    hn::StoreInterleaved3(words_of(origin),
                          words_of(dx),
                          words_of(dy),
                          Words(),
                          reinterpret_cast<std::uint64_t*>(group.depth.data() + lane));
    const auto round_depth = [&](VD plane) HWY_ATTR {
        const VD whole =
            hn::Floor(hn::Mul(hn::Add(plane, constant(DepthOne / 2)), constant(1 / DepthOne)));
        return hn::Min(hn::Max(whole, constant(0)), constant(depth_scale));
    };
    store_narrow(round_depth(least(z)), group.depth_min, lane);
    store_narrow(round_depth(greatest(z)), group.depth_max, lane);
    return hn::Not(hn::Lt(hn::Max(hn::Abs(exact_dx), hn::Abs(exact_dy)), constant(Steepest)));
}

// 1 / w of the vertices, scaled so that the greatest is in [1, 2).
struct PerspectiveLanes {
    MaskD varies, unusual;
    std::array<VD, 3> k;
    VD floor;

    HWY_INLINE explicit PerspectiveLanes(const std::array<VD, 3>& inverse_w) {
        constexpr auto Field = [](int exponent) {
            return static_cast<std::uint64_t>(exponent) << 52;
        };
        constexpr double Usual = 0x1p100;
        varies = hn::Or(hn::Ne(inverse_w[0], inverse_w[1]), hn::Ne(inverse_w[0], inverse_w[2]));
        const VD lowest = least(inverse_w), highest = greatest(inverse_w);
        unusual =
            hn::Not(hn::And(hn::Gt(lowest, constant(1 / Usual)), hn::Lt(highest, constant(Usual))));
        const VW exponent = hn::And(bits_of(highest), hn::Set(Words(), Field(0x7ff)));
        const VD to_one =
            hn::BitCast(Doubles(), hn::Sub(hn::Set(Words(), Field(2 * 1023)), exponent));
        for (unsigned j = 0; j < 3; ++j)
            k[j] = hn::IfThenElse(varies, hn::Mul(inverse_w[j], to_one), constant(1));
        const VD half = hn::Mul(hn::Mul(lowest, to_one), constant(1 << (ValueBits - 2)));
        floor = hn::Max(hn::Floor(half), constant(1));
    }
    HWY_INLINE VW base() const {
        return hn::IfThenElse(hn::RebindMask(Words(), varies),
                              hn::Set(Words(), scale_base(1)),
                              hn::Set(Words(), scale_base(ValueBits)));
    }
};

// A colour's place in the layout.
struct ColorSpan {
    unsigned first = 0, channels = 0;

    HWY_INLINE ColorSpan(int at, unsigned width)
        : first(static_cast<unsigned>(std::max(at, 0)))
        , channels(at < 0 ? 0 : width) {}
    bool holds(unsigned attribute) const {
        return attribute >= first && attribute < first + channels;
    }
};

HWY_INLINE VN attribute_bits(const VertexPairs& pairs, unsigned i, unsigned j, std::size_t lane) {
    return half_of(load(pairs.attributes[i / 2][j], lane), i % 2 != 0);
}

// Lanes whose vertices have the same bits in a colour; its bytes then.
HWY_INLINE MaskD set_up_constant(const VertexPairs& pairs,
                                 const ColorSpan& span,
                                 TriangleGroup::Each<std::uint32_t>& color,
                                 std::size_t lane) {
    const Narrow d;
    const Singles singles;
    VN different = hn::Zero(d), bytes = hn::Zero(d);
    for (unsigned c = span.channels; c-- > 0;) {
        const VN v0 = attribute_bits(pairs, span.first + c, 0, lane);
        for (unsigned j = 1; j < 3; ++j)
            different =
                hn::Or(different, hn::Xor(v0, attribute_bits(pairs, span.first + c, j, lane)));
        const auto value = hn::BitCast(singles, v0);
        const auto positive =
            hn::IfThenElseZero(hn::Gt(value, hn::Zero(singles)), value); // NaN is 0.
        const auto scaled =
            hn::Add(hn::Mul(hn::Min(positive, hn::Set(singles, 1)), hn::Set(singles, 255)),
                    hn::Set(singles, 0.5f));
        const auto byte = hn::ConvertTo(NarrowIntegers(), scaled);
        bytes = hn::Or(hn::ShiftLeft<8>(bytes), hn::BitCast(d, byte));
    }
    hn::StoreU(bytes, d, color.data() + lane);
    if (span.channels == 0) return hn::FirstN(Doubles(), 0);
    return hn::Eq(integers_of(different), constant(0));
}

// Attribute planes; returns the lanes that the specification has to set up. `live`: lanes that
// count.
HWY_INLINE MaskD set_up_planes(const SetupContext& context,
                               const VertexPairs& pairs,
                               const PerspectiveLanes& perspective,
                               const FrameLanes& frame,
                               MaskD live,
                               TriangleGroup& group,
                               std::size_t lane) {
    const InterpolantLayout& layout = context.layout;
    const ColorSpan color(layout.color, 4), secondary(layout.secondary, 3);
    const MaskD same_color = set_up_constant(pairs, color, group.color, lane);
    const MaskD same_secondary = set_up_constant(pairs, secondary, group.secondary, lane);
    group.constant_color |= bits_from(same_color, lane);
    group.constant_secondary |= bits_from(same_secondary, lane);
    const auto all_same = [&](MaskD same) HWY_ATTR {
        return hn::AllTrue(Doubles(), hn::Or(same, hn::Not(live)));
    };
    const bool skip_color = all_same(same_color), skip_secondary = all_same(same_secondary);
    const VW base = perspective.base();
    MaskD left = hn::FirstN(Doubles(), 0);
    for (unsigned i = 0; i < layout.count; ++i) {
        const bool in_color = color.holds(i), in_secondary = secondary.holds(i);
        if ((in_color && skip_color) || (in_secondary && skip_secondary)) continue;
        const VD factor = constant(in_color || in_secondary ? 255 : 1);
        std::array<VD, 3> values;
        for (unsigned j = 0; j < 3; ++j) // 255 k is exact, so that there is one rounding.
            values[j] = hn::Mul(floats_of(attribute_bits(pairs, i, j, lane)),
                                hn::Mul(factor, perspective.k[j]));
        const PlaneLanes plane = plane_lanes(values, base, frame);
        store(plane, group.planes[i].data() + lane);
        left = hn::Or(left, hn::Not(plane.sure));
    }
    if (hn::AllFalse(Doubles(), perspective.varies)) return left;
    const PlaneLanes plane = plane_lanes(perspective.k, base, frame);
    store(plane, group.planes[layout.count].data() + lane);
    return hn::Or(left, hn::AndNot(plane.sure, perspective.varies));
}

HWY_INLINE void set_up_vector(const SetupContext& context,
                              const VertexPairs& pairs,
                              TriangleGroup& group,
                              std::size_t lane) {
    const CornerLanes at(pairs, lane);
    const SideLanes sides(at);
    const BoxLanes box(at, context.clip);
    const ThreeEdges edges = edges_of(at, sides.area);
    const MaskD empty = hn::Or(box.are_empty(), hn::Eq(sides.area, constant(0)));
    const MaskD nothing = hn::AndNot(empty, miss_their_boxes(edges, box));
    const MaskD live = hn::Not(hn::Or(empty, nothing));
    box.store(group, lane);
    hn::StoreU(hn::Abs(sides.area), Doubles(), group.double_area.data() + lane);
    for (unsigned i = 0; i < 3; ++i)
        edges[i].store(group.edges[i], lane);
    const VD fractions = hn::Add(edges[0].fraction,
                                 hn::Add(hn::Mul(edges[1].fraction, constant(1 << 8)),
                                         hn::Mul(edges[2].fraction, constant(1 << 16))));
    store_narrow(fractions, group.edge_fractions, lane);
    group.empty |= bits_from(empty, lane);
    group.nothing |= bits_from(nothing, lane);
    MaskD alone = at.outside_guard_band();
    if (!hn::AllFalse(Doubles(), live)) {
        store_narrow(hn::Floor(hn::Mul(at.x[0], constant(PerPixel))), group.x_reference, lane);
        store_narrow(hn::Floor(hn::Mul(at.y[0], constant(PerPixel))), group.y_reference, lane);
        std::array<VD, 3> depths, inverse_w;
        for (unsigned j = 0; j < 3; ++j) {
            depths[j] = floats_of(half_of(load(pairs.depth[j], lane), false));
            inverse_w[j] = floats_of(half_of(load(pairs.depth[j], lane), true));
        }
        const BasisLanes basis(at, sides);
        const PerspectiveLanes perspective(inverse_w);
        store_narrow(perspective.floor, group.inverse_w_floor, lane);
        group.perspective |= bits_from(perspective.varies, lane);
        MaskD left = hn::Or(sides.are_slivers(), perspective.unusual);
        left = hn::Or(left, set_up_depth(depths, context.depth_scale, basis, group, lane));
        left = hn::Or(left,
                      set_up_planes(context, pairs, perspective, basis.frame, live, group, lane));
        alone = hn::Or(alone, hn::And(live, left));
    }
    group.alone |= bits_from(alone, lane);
}

} // namespace

void SetUpTriangles(const SetupContext& context,
                    std::span<const Primitive> triangles,
                    TriangleGroup& group) {
    VertexPairs pairs;
    collect(triangles, (context.layout.count + 1u) / 2, pairs);
    group.alone = group.empty = group.nothing = 0;
    group.perspective = group.constant_color = group.constant_secondary = 0;
    for (std::size_t lane = 0; lane < Size; lane += hn::Lanes(Doubles()))
        set_up_vector(context, pairs, group, lane);
}

} // namespace HWY_NAMESPACE
} // namespace ffgpu
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ffgpu {

HWY_EXPORT(SetUpTriangles);

void set_up_triangles(const SetupContext& context,
                      std::span<const Primitive> triangles,
                      TriangleGroup& group) {
    HWY_DYNAMIC_DISPATCH(SetUpTriangles)(context, triangles, group);
}

} // namespace ffgpu
#endif
