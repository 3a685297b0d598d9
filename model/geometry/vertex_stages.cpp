// The vertex stages over one lane: their specification.

#include "model/geometry/vertex_stages.h"

#include "model/arith/lanes/scalar_lanes.h"
#include "model/arith/power.h"
#include "model/arith/range.h"

#include <cstring>
#include <tuple>

#define FFGPU_LANES scalar_lanes
#include "model/geometry/vertex_stages.inl"

namespace ffgpu {

void shade_vertices_scalar(const VertexSetup& setup,
                           VertexBatch& batch,
                           const VertexRecords& records) {
    scalar_lanes::shade_vertices(setup, batch, records);
}

} // namespace ffgpu
