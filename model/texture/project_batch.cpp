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

HWY_INLINE VF not_nan(VF x) {
    return hn::IfThenElseZero(hn::Eq(x, x), x);
}

// Most draws have q = 1 everywhere, and dividing by it changes nothing.
void project(const float* coordinates, const float* q, unsigned lanes, float* out) {
    const DF d;
    for (unsigned lane = 0; lane < lanes; lane += static_cast<unsigned>(hn::Lanes(d))) {
        const VF divisor = hn::Load(d, q + lane);
        VF quotient = hn::Load(d, coordinates + lane);
        if (!hn::AllTrue(d, hn::Eq(divisor, hn::Set(d, 1.0f))))
            quotient = hn::Div(quotient, divisor);
        hn::Store(not_nan(quotient), d, out + lane);
    }
}

} // namespace
} // namespace ffgpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ffgpu {
namespace {

HWY_EXPORT(project);

using Plane = std::array<float, BatchFragments>;

void project_plane(const Plane& coordinates, const Plane& q, unsigned quad_count, Plane& out) {
    const unsigned lanes = 4 * grouped_quads(quad_count);
    HWY_DYNAMIC_DISPATCH(project)(coordinates.data(), q.data(), lanes, out.data());
    for (unsigned lane = 4 * quad_count; lane < lanes; ++lane)
        out[lane] = out[lane - 4];
}

void put(CoordinatePlanes& planes, unsigned lane, const TexCoord& coord) {
    planes.s[lane] = coord.s;
    planes.t[lane] = coord.t;
}

// Divergent by nature (a face per fragment), and rare: scalar.
void project_to_faces(unsigned quads, const FragmentMask& live, ProjectedBatch& out) {
    const auto direction_of = [&](unsigned lane) {
        return TexCoord{out.sample.s[lane], out.sample.t[lane], out.sample.r[lane]};
    };
    for (unsigned first = 0; first < 4 * quads; first += 4) {
        bool one_face = true;
        const unsigned quad_face = cube_face(direction_of(first + face_lane(live.quad(first / 4))));
        for (unsigned lane = first; lane < first + 4; ++lane) {
            const TexCoord direction = direction_of(lane);
            const unsigned face = cube_face(direction);
            out.face[lane] = static_cast<std::int32_t>(face);
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
                   const FragmentMask& live,
                   ProjectedBatch& out) {
    const bool cube = unit.kind == TextureKind::Cube;
    project_plane(coordinates.s, coordinates.q, quad_count, out.sample.s);
    if (unit.dimensions > 1) project_plane(coordinates.t, coordinates.q, quad_count, out.sample.t);
    if (unit.dimensions > 2 || cube || unit.compares())
        project_plane(coordinates.r, coordinates.q, quad_count, out.sample.r);
    if (cube) project_to_faces(grouped_quads(quad_count), live, out);
}

} // namespace ffgpu
#endif
