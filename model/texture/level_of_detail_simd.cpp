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
using VF = hn::Vec<DF>;
using VI = hn::Vec<DI>;

struct Steps {
    VF x[3], y[3];
};

HWY_INLINE VI constant(std::int32_t value) {
    return hn::Set(DI(), value);
}

// Differences of lanes 1 and 2 to lane 0 of each quad.
HWY_INLINE void load_steps(const float* plane, unsigned quad, VF& x, VF& y) {
    VF lane0, lane1, lane2, lane3;
    hn::LoadInterleaved4(DF(), plane + 4 * quad, lane0, lane1, lane2, lane3);
    x = hn::Sub(lane1, lane0);
    y = hn::Sub(lane2, lane0);
}

HWY_INLINE VI squared_length(const TextureUnit& unit, const VF* step) {
    VF sum = hn::Zero(DF());
    for (unsigned axis = 0; axis < unit.dimensions; ++axis) {
        const VF any = hn::Abs(hn::Mul(step[axis], hn::Set(DF(), unit.density[axis])));
        const VF texels =
            hn::Min(hn::Max(any, hn::Set(DF(), LeastStep)), hn::Set(DF(), LargestStep));
        const VF square = hn::Mul(texels, texels);
        sum = axis == 0 ? square : hn::Add(sum, square);
    }
    return hn::BitCast(DI(), sum);
}

HWY_INLINE VI log2_fixed8(VI bits) {
    const DI d;
    const VI entry = hn::And(hn::ShiftRight<15>(bits), constant(0xff));
    const auto* table = reinterpret_cast<const std::int32_t*>(Log2Table.data());
    const VI fraction = hn::And(hn::GatherOffset(d, table, entry), constant(0xff));
    const VI biased = hn::And(hn::ShiftRight<23>(bits), constant(0xff));
    const VI exponent = hn::Sub(biased, constant(127));
    return hn::Add(hn::ShiftLeft<8>(exponent), fraction);
}

HWY_INLINE VI count_probes(VI x, VI y, unsigned most) {
    const VI shorter = hn::Max(hn::Min(x, y), constant(0));
    const VI longer = hn::Sub(hn::Max(x, y), shorter);
    VI probes = constant(1);
    for (unsigned n = 1; n < most; ++n) {
        const auto more = hn::Gt(longer, constant(ProbeLogarithms[n]));
        probes = hn::Sub(probes, hn::VecFromMask(DI(), more));
    }
    return probes;
}

HWY_INLINE VI clamp(VI value, std::int32_t low, std::int32_t high) {
    return hn::Min(hn::Max(value, constant(low)), constant(high));
}

HWY_INLINE VI minified_choice(const TextureUnit& unit, VI lambda) {
    const auto last = static_cast<std::int32_t>(unit.last_level);
    const VI linear = constant(
        unit.sampler.minify_linear ? static_cast<std::int32_t>(SamplingBatch::LinearBit) : 0);
    if (unit.sampler.mip_filter == MipFilter::None) return linear;
    if (unit.sampler.mip_filter == MipFilter::Nearest) {
        const VI nearest = hn::ShiftRight<8>(hn::Add(lambda, constant(127)));
        return hn::Or(linear, clamp(nearest, 0, last));
    }
    const VI level = clamp(hn::ShiftRight<8>(lambda), 0, last);
    const VI next = hn::Min(hn::Add(level, constant(1)), constant(last));
    const VI fraction = hn::And(lambda, constant(0xff));
    const VI weight = hn::IfThenElseZero(hn::Lt(level, constant(last)), fraction);
    const VI levels = hn::Or(level, hn::ShiftLeft<8>(next));
    return hn::Or(linear, hn::Or(levels, hn::ShiftLeft<16>(weight)));
}

HWY_INLINE VI choose(const TextureUnit& unit, VI lambda) {
    const VI magnified = constant(
        unit.sampler.magnify_linear ? static_cast<std::int32_t>(SamplingBatch::LinearBit) : 0);
    const auto minifies = hn::Gt(lambda, constant(unit.magnify_limit));
    return hn::IfThenElse(minifies, minified_choice(unit, lambda), magnified);
}

HWY_INLINE VI level_of_detail(const TextureUnit& unit, VI logarithm) {
    const VI lambda = hn::Add(hn::ShiftRight<1>(logarithm), constant(unit.sampler.bias));
    return clamp(lambda, unit.sampler.min_lod, unit.sampler.max_lod);
}

HWY_INLINE void store_quads(VF value, float* plane) {
    hn::StoreInterleaved4(value, value, value, value, DF(), plane);
}

// One vector of quads for anisotropic filtering: number of probes and the step between them.
// Returns what the probes take off the logarithm.
HWY_INLINE VI store_probes(const TextureUnit& unit,
                           const Steps& steps,
                           VI x,
                           VI y,
                           const LevelInputs& in,
                           unsigned quad,
                           SamplingBatch& out) {
    constexpr unsigned Lanes = hn::MaxLanes(DF());
    const DF d;
    const VI probes = count_probes(log2_fixed8(x), log2_fixed8(y), unit.max_probes);
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
    VI all_of = constant(-1), any_of = constant(0);
    const DU du;
    for (unsigned quad = 0; quad < quad_count; quad += static_cast<unsigned>(hn::Lanes(du))) {
        Steps steps;
        for (unsigned axis = 0; axis < 3; ++axis) {
            steps.x[axis] = steps.y[axis] = hn::Zero(DF());
            if (axis < unit.dimensions) load_steps(axes[axis], quad, steps.x[axis], steps.y[axis]);
        }
        const VI x = squared_length(unit, steps.x), y = squared_length(unit, steps.y);
        VI logarithm = log2_fixed8(hn::Max(x, y));
        if (unit.max_probes > 1)
            logarithm = hn::Sub(logarithm, store_probes(unit, steps, x, y, in, quad, out));
        const VI choice = choose(unit, level_of_detail(unit, logarithm));
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

void choose_levels_batch(const TextureUnit& unit,
                         const LevelInputs& inputs,
                         unsigned quad_count,
                         SamplingBatch& out) {
    out.all_of = ~0u;
    out.any_of = 0;
    out.max_probes = 1;
    HWY_DYNAMIC_DISPATCH(choose_levels)(unit, inputs, grouped_quads(quad_count), out);
}

} // namespace ffgpu
#endif
