// The vertex stages over vectors, compiled once for each instruction set that is worth it.

// SSSE3 adds nothing here to SSE2; SVE's vectors have no size and cannot be members.
#define HWY_DISABLED_TARGETS                                                                       \
    (HWY_SSSE3 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)

#include "model/arith/lanes/scalar_lanes.h"
#include "model/arith/power.h"
#include "model/arith/range.h"
#include "model/geometry/vertex_stages.h"

#include <cstring>
#include <tuple>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/geometry/vertex_stages_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#undef FFGPU_LANES
#define FFGPU_LANES HWY_NAMESPACE

HWY_BEFORE_NAMESPACE();
#include "model/arith/lanes/highway_lanes.inl"
#include "model/geometry/vertex_stages.inl"
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ffgpu {
HWY_EXPORT(shade_vertices);

void shade_vertices_simd(const VertexSetup& setup,
                         VertexBatch& batch,
                         const VertexRecords& records) {
    HWY_DYNAMIC_DISPATCH(shade_vertices)(setup, batch, records);
}

} // namespace ffgpu
#endif
