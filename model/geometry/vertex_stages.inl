// The vertex stages in their order, and the way from the batch's planes to records.

// In this order: each builds on those before it.
// clang-format off
#include "model/geometry/vectors.inl"
#include "model/geometry/power.inl"
#include "model/geometry/transform_stage.inl"
#include "model/geometry/lighting_stage.inl"
#include "model/geometry/tex_coord_stage.inl"
#include "model/geometry/distance_stage.inl"
#include "model/geometry/window_stage.inl"
// clang-format on

namespace ffgpu::FFGPU_LANES {

// The range rule (model/arith/range.h): interpolants that are NaN, too large or too small become 0.
inline void put_in_range(const float* from, Plane& to, unsigned count) {
    for (unsigned lane = 0; lane < count; lane += LaneCount) {
        const Floats x = load(from + lane), magnitude = absolute(x);
        const Mask inside = (magnitude >= splat(LeastValue)) & (magnitude < splat(LargestValue));
        store(zero_unless(inside, x), to.at(lane));
    }
}

// Moves four planes to the records at `row`, which lie row_bytes apart. Rows are written for whole
// vectors: up to LaneCount - 1 records more than there are vertices.
inline void move_rows(std::array<const float*, 4> planes,
                      std::byte* row,
                      std::size_t row_bytes,
                      unsigned count) {
    for (unsigned lane = 0; lane < count; lane += LaneCount, row += LaneCount * row_bytes) {
        store_rows(planes, row, row_bytes);
        for (const float*& plane : planes)
            plane += LaneCount;
    }
}

inline std::array<const float*, 4> lanes_of(const Planes4& planes) {
    return {planes[0].at(0), planes[1].at(0), planes[2].at(0), planes[3].at(0)};
}

inline void
move_interpolants(const VertexSetup& setup, const VertexBatch& batch, WindowVertex* vertices) {
    const InterpolantSources sources = interpolant_sources(setup, batch);
    const unsigned count = setup.layout.count;
    Planes4 finite;
    for (unsigned first = 0; first < count; first += 4) {
        const unsigned width = count - first < 4 ? count - first : 4;
        for (unsigned i = 0; i < width; ++i)
            put_in_range(sources[first + i]->at(0), finite[i], batch.count);
        if (first + 4 <= MaxInterpolants) {
            move_rows(lanes_of(finite),
                      reinterpret_cast<std::byte*>(vertices->attributes.data() + first),
                      sizeof(WindowVertex),
                      batch.count);
        } else { // The last interpolant of all: a row of four would reach the next vertex.
            for (unsigned lane = 0; lane < batch.count; ++lane)
                for (unsigned i = 0; i < width; ++i)
                    vertices[lane].attributes[first + i] = finite[i].lanes[lane];
        }
    }
}

inline void
move_to_records(const VertexSetup& setup, const VertexBatch& batch, const VertexRecords& records) {
    const unsigned count = batch.count;
    move_rows(lanes_of(batch.window),
              reinterpret_cast<std::byte*>(records.window),
              sizeof(WindowVertex),
              count);
    move_rows(lanes_of(batch.clip), reinterpret_cast<std::byte*>(records.clip), 16, count);
    if (setup.registers->clip_planes.enable != 0)
        move_rows(lanes_of(batch.eye), reinterpret_cast<std::byte*>(records.eye), 16, count);
    std::memcpy(records.codes, batch.codes.data(), count * sizeof(ClipCode));
    move_interpolants(setup, batch, records.window);
}

// Whether no primitive of the vertices is drawn: all lie beyond one plane.
inline bool all_outside(const VertexBatch& batch) {
    ClipCode common = clip_code::Outside | clip_code::SmallW;
    for (unsigned lane = 0; lane < batch.count; ++lane)
        common &= batch.codes[lane];
    return common != 0;
}

// What leaves nothing to draw needs no colours: whole objects beside the picture are common.
void shade_vertices(const VertexSetup& setup, VertexBatch& batch, const VertexRecords& records) {
    transform_stage(setup, batch);
    window_stage(setup, batch);
    if (batch.whole_chunk && all_outside(batch)) {
        std::memcpy(records.codes, batch.codes.data(), batch.count * sizeof(ClipCode));
        return;
    }
    color_stage(setup, batch);
    tex_coord_stage(setup, batch);
    distance_stage(setup, batch);
    move_to_records(setup, batch, records);
}

} // namespace ffgpu::FFGPU_LANES
