// GeometryWorker: a thread's share of geometry: a unit, and what bins its primitives.

#pragma once

#include "model/base/cache_lines.h"
#include "model/geometry/geometry_unit.h"
#include "model/gpu/primitive_binner.h"

#include <cstddef>
#include <span>

namespace ffgpu {

struct alignas(CacheLinePair) GeometryWorker {
    GeometryUnit geometry;
    PrimitiveBinner binner;

    GeometryWorker(std::span<const std::byte> memory, const Stages& stages)
        : geometry(memory, stages.shade_vertices)
        , binner(stages) {}
};

} // namespace ffgpu
