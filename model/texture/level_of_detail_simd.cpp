// Vector form of level_of_detail.h: a lane a quad.

#include "model/texture/level_of_detail.h"
#include "model/texture/sampling_batch.h"
#include "model/texture/simd_targets.h"

#include <algorithm>

// Highway's order of includes.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/texture/level_of_detail_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace ffgpu::HWY_NAMESPACE {
namespace {
namespace hn = hwy::HWY_NAMESPACE;

using DF = hn::CappedTag<float, QuadGroup>;
using DI = hn::RebindToSigned<DF>;
using DU = hn::RebindToUnsigned<DF>;
using Floats = hn::Vec<DF>;
using Integers = hn::Vec<DI>;

HWY_INLINE Floats splat(float value) {
    return hn::Set(DF(), value);
}
HWY_INLINE Integers splat_integer(std::int32_t value) {
    return hn::Set(DI(), value);
}
HWY_INLINE Floats absolute(Floats a) {
    return hn::Abs(a);
}
template <class Numbers>
HWY_INLINE Numbers minimum(Numbers a, Numbers b) {
    return hn::Min(a, b);
}
template <class Numbers>
HWY_INLINE Numbers maximum(Numbers a, Numbers b) {
    return hn::Max(a, b);
}
HWY_INLINE Integers bits_of(Floats a) {
    return hn::BitCast(DI(), a);
}
template <int Bits>
HWY_INLINE Integers shift_left(Integers a) {
    return hn::ShiftLeft<Bits>(a);
}
template <int Bits>
HWY_INLINE Integers shift_right(Integers a) {
    return hn::ShiftRight<Bits>(a);
}
HWY_INLINE Integers log2_entry(Integers at) {
    const auto* table = reinterpret_cast<const std::int32_t*>(Log2Table.data());
    return hn::And(hn::GatherOffset(DI(), table, at), splat_integer(0xff));
}
HWY_INLINE Integers where_greater(Integers a, Integers b, Integers yes, Integers no) {
    return hn::IfThenElse(hn::Gt(a, b), yes, no);
}
HWY_INLINE Integers one_more_where_greater(Integers value, Integers a, Integers b) {
    return hn::Sub(value, hn::VecFromMask(DI(), hn::Gt(a, b)));
}

} // namespace
} // namespace ffgpu::HWY_NAMESPACE

#undef FFGPU_LANES
#define FFGPU_LANES HWY_NAMESPACE
#include "model/texture/level_of_detail.inl"

namespace ffgpu::HWY_NAMESPACE {
namespace {

struct Steps {
    Floats x[3], y[3];
};

// Differences of lanes 1 and 2 to lane 0 of each quad.
HWY_INLINE void load_steps(const float* plane, unsigned quad, Floats& x, Floats& y) {
    Floats lane0, lane1, lane2, lane3;
    hn::LoadInterleaved4(DF(), plane + 4 * quad, lane0, lane1, lane2, lane3);
    x = hn::Sub(lane1, lane0);
    y = hn::Sub(lane2, lane0);
}

HWY_INLINE void store_quads(Floats value, float* plane) {
    hn::StoreInterleaved4(value, value, value, value, DF(), plane);
}

// One vector of quads for anisotropic filtering: number of probes and the step between them.
// Returns what the probes take off the logarithm.
HWY_INLINE Integers store_probes(const TextureUnit& unit,
                                 const Steps& steps,
                                 Integers x,
                                 Integers y,
                                 const LevelInputs& in,
                                 unsigned quad,
                                 SamplingBatch& out) {
    constexpr unsigned Lanes = hn::MaxLanes(DF());
    const DF d;
    const Integers probes = probes_between(logarithm(x), logarithm(y), unit.max_probes);
    alignas(64) std::int32_t counts[Lanes];
    hn::Store(probes, DI(), counts);
    for (unsigned i = 0; i < Lanes; ++i) {
        if (in.one_face && !in.one_face[quad + i]) counts[i] = 1;
        out.probes[quad + i] = static_cast<std::uint8_t>(counts[i]);
        out.max_probes = std::max(out.max_probes, static_cast<unsigned>(counts[i]));
    }
    const auto y_longer = hn::RebindMask(d, hn::Gt(y, x));
    store_quads(hn::IfThenElse(y_longer, steps.y[0], steps.x[0]),
                out.major_step.s.data() + 4 * quad);
    store_quads(hn::IfThenElse(y_longer, steps.y[1], steps.x[1]),
                out.major_step.t.data() + 4 * quad);
    store_quads(hn::IfThenElse(y_longer, steps.y[2], steps.x[2]),
                out.major_step.r.data() + 4 * quad);
    return hn::GatherIndex(DI(), ProbeLogarithms.data(), hn::Load(DI(), counts));
}

void choose_levels(const TextureUnit& unit,
                   const LevelInputs& in,
                   unsigned quad_count,
                   SamplingBatch& out) {
    const TexCoordPlanes& planes = *in.coordinates;
    const float* axes[3] = {planes.s.data(), planes.t.data(), planes.r.data()};
    Integers all_of = splat_integer(-1), any_of = splat_integer(0);
    const DU du;
    for (unsigned quad = 0; quad < quad_count; quad += static_cast<unsigned>(hn::Lanes(du))) {
        Steps steps;
        for (unsigned axis = 0; axis < 3; ++axis) {
            steps.x[axis] = steps.y[axis] = hn::Zero(DF());
            if (axis < unit.dimensions) load_steps(axes[axis], quad, steps.x[axis], steps.y[axis]);
        }
        const Integers x = squared_length(unit, steps.x), y = squared_length(unit, steps.y);
        Integers longer = logarithm(hn::Max(x, y));
        if (unit.max_probes > 1)
            longer = hn::Sub(longer, store_probes(unit, steps, x, y, in, quad, out));
        const Integers choice = choice_of(unit, lambda_of(unit, longer));
        all_of = hn::And(all_of, choice);
        any_of = hn::Or(any_of, choice);
        const auto word = hn::BitCast(du, choice);
        hn::StoreInterleaved4(word, word, word, word, du, out.choice.data() + 4 * quad);
    }
    alignas(64) std::uint32_t all_lanes[hn::MaxLanes(DF())], any_lanes[hn::MaxLanes(DF())];
    hn::Store(hn::BitCast(du, all_of), du, all_lanes);
    hn::Store(hn::BitCast(du, any_of), du, any_lanes);
    for (unsigned i = 0; i < hn::Lanes(du); ++i) {
        out.all_of &= all_lanes[i];
        out.any_of |= any_lanes[i];
    }
}

} // namespace
} // namespace ffgpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ffgpu {
namespace {
HWY_EXPORT(choose_levels);
} // namespace

namespace {

// One level, and one filter whether it magnifies or minifies.
bool has_one_choice(const TextureUnit& unit) {
    const Sampler& sampler = unit.sampler;
    return unit.max_probes == 1 && sampler.mip_filter == MipFilter::None &&
           sampler.minify_linear == sampler.magnify_linear;
}

} // namespace

void choose_levels_batch(const TextureUnit& unit,
                         const LevelInputs& inputs,
                         unsigned quad_count,
                         SamplingBatch& out) {
    out.max_probes = 1;
    if (has_one_choice(unit)) {
        out.all_of = out.any_of = unit.sampler.minify_linear ? SamplingBatch::LinearBit : 0;
        std::fill_n(out.choice.begin(), 4 * grouped_quads(quad_count), out.any_of);
        return;
    }
    out.all_of = ~0u;
    out.any_of = 0;
    HWY_DYNAMIC_DISPATCH(choose_levels)(unit, inputs, grouped_quads(quad_count), out);
}

} // namespace ffgpu
#endif
