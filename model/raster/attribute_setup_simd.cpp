// The fast form of attribute_setup.cpp for one primitive: a lane an attribute.

#include "model/base/simd_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/raster/attribute_setup_simd.cpp"

#include "model/raster/attribute_setup.h"

#include <algorithm>
#include <array>
#include <bit>

#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// clang-format off: after foreach_target.h
#include "model/arith/lanes/mask_bits-inl.h"
#include "model/raster/attribute_lanes-inl.h"
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace ffgpu {
namespace HWY_NAMESPACE {

// As many values as a vector has and the layout carries, promoted; the others are 0.
HWY_INLINE VD load_floats(const float* from, unsigned first, unsigned carried) {
    const hn::Rebind<float, Doubles> d;
    if (first + hn::Lanes(d) <= MaxInterpolants) [[likely]]
        return hn::PromoteTo(Doubles(), hn::MaskedLoad(hn::FirstN(d, carried), d, from + first));
    std::array<float, 8> rest{};
    std::copy_n(from + first, carried, rest.begin());
    return hn::PromoteTo(Doubles(), hn::LoadU(d, rest.data()));
}

// Lanes whose bit from `first` on is set.
HWY_INLINE hn::Mask<Doubles> lanes_of(std::uint64_t bits, unsigned first) {
    const auto bytes = std::bit_cast<std::array<std::uint8_t, 8>>(bits >> first);
    return hn::LoadMaskBits(Doubles(), bytes.data());
}

// The attributes from `first` on at the three vertices: AttributeValues::at().
HWY_INLINE std::array<VD, 3> load_values(const AttributeValues& values, unsigned first) {
    const unsigned count = values.layout.count;
    const unsigned carried =
        std::min(std::max(count, first) - first, static_cast<unsigned>(hn::Lanes(Doubles())));
    const VD factor =
        hn::IfThenElse(lanes_of(values.color_bits(), first), constant(255), constant(1));
    const auto is_k = lanes_of(std::uint64_t{1} << count, first);
    const auto at = [&](unsigned j) HWY_ATTR {
        const VD k = constant(values.k[j]);
        // 255 k is exact, so that there is one rounding.
        const VD value = hn::Mul(load_floats(values.of[j], first, carried), hn::Mul(factor, k));
        return hn::IfThenElse(is_k, k, value);
    };
    return {at(0), at(1), at(2)};
}

// Of one primitive, for all its attributes.
HWY_INLINE FrameLanes spread_frame(const AttributeFrame& frame) {
    const PlaneBasis& basis = frame.basis;
    return {.x1 = constant(basis.x1),
            .x2 = constant(basis.x2),
            .y1 = constant(basis.y1),
            .y2 = constant(basis.y2),
            .factor = constant(ExactQuotient::factor(basis.per_divisor)),
            .offset_x = constant(frame.offset.x),
            .offset_y = constant(frame.offset.y),
            .reach = FrameLanes::reach_of(frame.reach)};
}

// Returns a bit for each attribute that the specification has to set up.
std::uint64_t
SetUpPlanes(const AttributeValues& values, const AttributeFrame& frame, StoredPlane* planes) {
    const FrameLanes constants = spread_frame(frame);
    const VW base = hn::Set(Words(), scale_base(values.base_exponent()));
    const unsigned count = values.count();
    std::uint64_t left = 0;
    for (unsigned i = 0; i < count; i += static_cast<unsigned>(hn::Lanes(Doubles()))) {
        const PlaneLanes plane = plane_lanes(load_values(values, i), base, constants);
        store(plane, planes + i);
        left |= bits_from_mask(Doubles(), hn::Not(plane.sure)) << i;
    }
    return left & ((std::uint64_t{1} << count) - 1);
}

} // namespace HWY_NAMESPACE
} // namespace ffgpu
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ffgpu {

HWY_EXPORT(SetUpPlanes);

int set_up_attributes(const AttributeValues& values,
                      const AttributeFrame& frame,
                      StoredPlane* planes) {
    const std::uint64_t left = HWY_DYNAMIC_DISPATCH(SetUpPlanes)(values, frame, planes);
    if (left == 0) return values.base_exponent();
    if (values.perspective && left >> values.layout.count != 0)
        return set_up_attributes_scalar(values, frame, planes);
    for (std::uint64_t rest = left; rest != 0; rest &= rest - 1) {
        const auto i = static_cast<unsigned>(std::countr_zero(rest));
        planes[i] = set_up_attribute(values.at(i), frame, values.base_exponent());
    }
    return values.base_exponent();
}

} // namespace ffgpu
#endif
