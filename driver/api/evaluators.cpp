// Evaluators: vertices on Bezier curves and surfaces (GL 1.5, 5.1).

#include "driver/commands/declarations.h"
#include "driver/context/context.h"
#include "driver/evaluators/evaluate_vertex.h"
#include "driver/vertex/immediate_vertices.h"

#include <cstdint>

namespace ffgpu::gl::api {
namespace {

// The grid's lines are counted in 64 bits, so that the largest GLint ends a loop, too.
using Line = std::int64_t;

void eval_mesh_line_u(Context& context, GLint p1, GLint p2, float v) {
    const EvaluatorSettings& settings = context.state.evaluator.settings;
    context.immediate().begin(GL_LINE_STRIP);
    for (Line i = p1; i <= p2; ++i)
        evaluate_vertex_2(context, grid_parameter(settings.grid2[0], i), v);
    context.immediate().end();
}

void eval_mesh_line_v(Context& context, GLint q1, GLint q2, float u) {
    const EvaluatorSettings& settings = context.state.evaluator.settings;
    context.immediate().begin(GL_LINE_STRIP);
    for (Line j = q1; j <= q2; ++j)
        evaluate_vertex_2(context, u, grid_parameter(settings.grid2[1], j));
    context.immediate().end();
}

} // namespace

void EvalCoord1f(Context& context, GLfloat u) {
    evaluate_vertex_1(context, u);
}

void EvalCoord1d(Context& context, GLdouble u) {
    EvalCoord1f(context, static_cast<GLfloat>(u));
}

void EvalCoord1fv(Context& context, const GLfloat* u) {
    EvalCoord1f(context, u[0]);
}

void EvalCoord1dv(Context& context, const GLdouble* u) {
    EvalCoord1d(context, u[0]);
}

void EvalCoord2f(Context& context, GLfloat u, GLfloat v) {
    evaluate_vertex_2(context, u, v);
}

void EvalCoord2d(Context& context, GLdouble u, GLdouble v) {
    EvalCoord2f(context, static_cast<GLfloat>(u), static_cast<GLfloat>(v));
}

void EvalCoord2fv(Context& context, const GLfloat* u) {
    EvalCoord2f(context, u[0], u[1]);
}

void EvalCoord2dv(Context& context, const GLdouble* u) {
    EvalCoord2d(context, u[0], u[1]);
}

void EvalPoint1(Context& context, GLint i) {
    evaluate_vertex_1(context, grid_parameter(context.state.evaluator.settings.grid1, i));
}

void EvalPoint2(Context& context, GLint i, GLint j) {
    const auto& grid = context.state.evaluator.settings.grid2;
    evaluate_vertex_2(context, grid_parameter(grid[0], i), grid_parameter(grid[1], j));
}

void EvalMesh1(Context& context, GLenum mode, GLint i1, GLint i2) {
    if (context.fails_inside_begin()) return;
    if (mode != GL_POINT && mode != GL_LINE) return context.error(GL_INVALID_ENUM);
    const EvaluatorGrid& grid = context.state.evaluator.settings.grid1;
    context.immediate().begin(mode == GL_POINT ? GL_POINTS : GL_LINE_STRIP);
    for (Line i = i1; i <= i2; ++i)
        evaluate_vertex_1(context, grid_parameter(grid, i));
    context.immediate().end();
}

void EvalMesh2(Context& context, GLenum mode, GLint i1, GLint i2, GLint j1, GLint j2) {
    if (context.fails_inside_begin()) return;
    const auto& grid = context.state.evaluator.settings.grid2;
    const auto u = [&](Line i) { return grid_parameter(grid[0], i); };
    const auto v = [&](Line j) { return grid_parameter(grid[1], j); };
    ImmediateVertices& vertices = context.immediate();
    switch (mode) {
    case GL_POINT:
        vertices.begin(GL_POINTS);
        for (Line j = j1; j <= j2; ++j) {
            for (Line i = i1; i <= i2; ++i)
                evaluate_vertex_2(context, u(i), v(j));
        }
        return vertices.end();
    case GL_LINE:
        for (Line j = j1; j <= j2; ++j)
            eval_mesh_line_u(context, i1, i2, v(j));
        for (Line i = i1; i <= i2; ++i)
            eval_mesh_line_v(context, j1, j2, u(i));
        return;
    case GL_FILL:
        for (Line j = j1; j < j2; ++j) {
            vertices.begin(GL_QUAD_STRIP);
            for (Line i = i1; i <= i2; ++i) {
                evaluate_vertex_2(context, u(i), v(j));
                evaluate_vertex_2(context, u(i), v(j + 1));
            }
            vertices.end();
        }
        return;
    default:
        return context.error(GL_INVALID_ENUM);
    }
}

} // namespace ffgpu::gl::api
