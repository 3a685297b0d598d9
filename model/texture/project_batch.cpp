// Vector form of coordinates.h.

#include "model/texture/coordinates.h"
#include "model/texture/sampling_batch.h"
#include "model/texture/simd_targets.h"

#include <algorithm>

// Highway's order of includes.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/texture/project_batch.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace ffgpu::HWY_NAMESPACE {
namespace {
namespace hn = hwy::HWY_NAMESPACE;

using DF = hn::CappedTag<float, 16>;
using VF = hn::Vec<DF>;

HWY_INLINE VF divide_or_zero(VF a, VF q) {
    const VF quotient = hn::Div(a, q);
    return hn::IfThenElseZero(hn::Eq(quotient, quotient), quotient);
}

void project(const TexCoordPlanes& in, unsigned lanes, CoordinatePlanes& out) {
    const DF d;
    for (unsigned lane = 0; lane < lanes; lane += static_cast<unsigned>(hn::Lanes(d))) {
        const VF q = hn::Load(d, in.q.data() + lane);
        hn::Store(divide_or_zero(hn::Load(d, in.s.data() + lane), q), d, out.s.data() + lane);
        hn::Store(divide_or_zero(hn::Load(d, in.t.data() + lane), q), d, out.t.data() + lane);
        hn::Store(divide_or_zero(hn::Load(d, in.r.data() + lane), q), d, out.r.data() + lane);
    }
}

} // namespace
} // namespace ffgpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ffgpu {
namespace {

HWY_EXPORT(project);

void repeat_last_quad(std::array<float, BatchFragments>& plane, unsigned quad_count) {
    for (unsigned lane = 4 * quad_count; lane < 4 * grouped_quads(quad_count); ++lane)
        plane[lane] = plane[lane - 4];
}

void put(CoordinatePlanes& planes, unsigned lane, const TexCoord& coord) {
    planes.s[lane] = coord.s;
    planes.t[lane] = coord.t;
}

// Divergent by nature (a face per fragment), and rare: scalar.
void project_to_faces(unsigned lanes, ProjectedBatch& out) {
    for (unsigned first = 0; first < lanes; first += 4) {
        bool one_face = true;
        for (unsigned lane = first; lane < first + 4; ++lane) {
            const TexCoord direction{out.sample.s[lane], out.sample.t[lane], out.sample.r[lane]};
            const unsigned face = cube_face(direction);
            out.face[lane] = static_cast<std::int32_t>(face);
            const auto quad_face = static_cast<unsigned>(out.face[first]);
            one_face &= face == quad_face;
            put(out.sample, lane, project_to_face(face, direction));
            put(out.level_of_detail, lane, project_to_face(quad_face, direction));
        }
        out.one_face[first / 4] = one_face;
    }
}

} // namespace

void project_batch(const TextureUnit& unit,
                   const TexCoordPlanes& coordinates,
                   unsigned quad_count,
                   ProjectedBatch& out) {
    const unsigned lanes = 4 * grouped_quads(quad_count);
    HWY_DYNAMIC_DISPATCH(project)(coordinates, lanes, out.sample);
    repeat_last_quad(out.sample.s, quad_count);
    repeat_last_quad(out.sample.t, quad_count);
    repeat_last_quad(out.sample.r, quad_count);
    if (unit.kind == TextureKind::Cube) project_to_faces(lanes, out);
}

} // namespace ffgpu
#endif
