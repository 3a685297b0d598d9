// The fast form of set_up_triangles(): the numbers of set_up(), a lane a triangle, in binary64,
// where all that are integers are exact. What follows from a division and is rounded is computed in
// the same order of operations.

#include "model/base/simd_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/raster/triangle_group_simd.cpp"

#include "model/raster/triangle_group.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// clang-format off: after foreach_target.h
#include "model/raster/attribute_lanes-inl.h"
#include "model/raster/triangle_lanes-inl.h"
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace ffgpu {
namespace HWY_NAMESPACE {
namespace {

constexpr double DepthOne = std::int64_t{1} << DepthPlane::FractionBits;

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
    collect(triangles, context.layout.count, pairs);
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
