// glEvalCoord: the vertex that the enabled maps make at a parameter (GL 1.5, 5.1).

#pragma once

#include <cstdint>

namespace ffgpu::gl {

class VertexContext;

void evaluate_vertex_1(VertexContext& context, float u);
void evaluate_vertex_2(VertexContext& context, float u, float v);

// Parameters of the grid's line i (glMapGrid).
struct EvaluatorGrid;
float grid_parameter(const EvaluatorGrid& grid, std::int64_t i);

} // namespace ffgpu::gl
