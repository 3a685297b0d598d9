// The vertex stages: transform, colours, texture coordinates, distances, window coordinates.
//
// They are written once, in the .inl files, over lanes: as one lane of plain C++ they are the
// specification, as vectors of the host's widest instruction set they are what runs. Both give the
// same bits.

#pragma once

#include "model/geometry/clip_code.h"
#include "model/geometry/vertex_batch.h"
#include "model/geometry/vertex_setup.h"
#include "model/packets/window_vertex.h"

#include <cstdint>

namespace ffgpu {

// Where a batch's vertices go. There is room for 64 records, however many vertices there are.
struct VertexRecords {
    WindowVertex* window = nullptr; // without point_size
    Vec4* clip = nullptr;
    Vec4* eye = nullptr; // only where user clip planes are enabled
    ClipCode* codes = nullptr;
};

// Takes batch.in and batch.count; all other planes are results.
void shade_vertices_scalar(const VertexSetup& setup,
                           VertexBatch& batch,
                           const VertexRecords& records);
void shade_vertices_simd(const VertexSetup& setup,
                         VertexBatch& batch,
                         const VertexRecords& records);

using ShadeVertices = void (*)(const VertexSetup&, VertexBatch&, const VertexRecords&);

} // namespace ffgpu
