// Matrices (GL 1.5, 2.11.2).

#include "driver/commands/declarations.h"
#include "driver/context/context.h"
#include "driver/math/matrix.h"

#include <algorithm>

namespace ffgpu::gl::api {
namespace {

// The stack that the matrix commands act on; its group of state is marked as changed.
MatrixStack& current_stack(Context& context) {
    MatrixState& matrices = context.state.transform.matrices;
    switch (context.state.transform.group.matrix_mode) {
    case GL_PROJECTION:
        context.dirty.mark(Dirty::Matrices);
        return matrices.projection;
    case GL_TEXTURE:
        context.dirty.mark(Dirty::TextureMatrices);
        return matrices.texture[context.state.texture.active_unit];
    default:
        context.dirty.mark(Dirty::Matrices);
        return matrices.model_view;
    }
}

void load(Context& context, const Mat4& matrix) {
    current_stack(context).top() = matrix;
}

void multiply_current(Context& context, const Mat4& matrix) {
    Mat4& top = current_stack(context).top();
    top = multiply(top, matrix);
}

template <class Number>
Mat4 read_matrix(const Number* elements) {
    Mat4 matrix;
    std::transform(
        elements, elements + 16, matrix.begin(), [](Number e) { return static_cast<float>(e); });
    return matrix;
}

} // namespace

void MatrixMode(Context& context, GLenum mode) {
    if (mode != GL_MODELVIEW && mode != GL_PROJECTION && mode != GL_TEXTURE)
        return context.error(GL_INVALID_ENUM);
    context.state.transform.group.matrix_mode = mode;
}

void LoadIdentity(Context& context) {
    load(context, Identity4);
}

void LoadMatrixf(Context& context, const GLfloat* m) {
    load(context, read_matrix(m));
}

void LoadMatrixd(Context& context, const GLdouble* m) {
    load(context, read_matrix(m));
}

void LoadTransposeMatrixf(Context& context, const GLfloat* m) {
    load(context, transpose(read_matrix(m)));
}

void LoadTransposeMatrixd(Context& context, const GLdouble* m) {
    load(context, transpose(read_matrix(m)));
}

void MultMatrixf(Context& context, const GLfloat* m) {
    multiply_current(context, read_matrix(m));
}

void MultMatrixd(Context& context, const GLdouble* m) {
    multiply_current(context, read_matrix(m));
}

void MultTransposeMatrixf(Context& context, const GLfloat* m) {
    multiply_current(context, transpose(read_matrix(m)));
}

void MultTransposeMatrixd(Context& context, const GLdouble* m) {
    multiply_current(context, transpose(read_matrix(m)));
}

void Rotatef(Context& context, GLfloat angle, GLfloat x, GLfloat y, GLfloat z) {
    multiply_current(context, rotation(angle, x, y, z));
}

void Rotated(Context& context, GLdouble angle, GLdouble x, GLdouble y, GLdouble z) {
    multiply_current(context, rotation(angle, x, y, z));
}

void Scalef(Context& context, GLfloat x, GLfloat y, GLfloat z) {
    multiply_current(context, scaling(x, y, z));
}

void Scaled(Context& context, GLdouble x, GLdouble y, GLdouble z) {
    multiply_current(context, scaling(x, y, z));
}

void Translatef(Context& context, GLfloat x, GLfloat y, GLfloat z) {
    multiply_current(context, translation(x, y, z));
}

void Translated(Context& context, GLdouble x, GLdouble y, GLdouble z) {
    multiply_current(context, translation(x, y, z));
}

void Frustum(Context& context,
             GLdouble left,
             GLdouble right,
             GLdouble bottom,
             GLdouble top,
             GLdouble near,
             GLdouble far) {
    if (near <= 0 || far <= 0 || near == far || left == right || bottom == top)
        return context.error(GL_INVALID_VALUE);
    multiply_current(context, frustum(left, right, bottom, top, near, far));
}

void Ortho(Context& context,
           GLdouble left,
           GLdouble right,
           GLdouble bottom,
           GLdouble top,
           GLdouble near,
           GLdouble far) {
    if (near == far || left == right || bottom == top) return context.error(GL_INVALID_VALUE);
    multiply_current(context, ortho(left, right, bottom, top, near, far));
}

void PushMatrix(Context& context) {
    if (!current_stack(context).push()) context.error(GL_STACK_OVERFLOW);
}

void PopMatrix(Context& context) {
    if (!current_stack(context).pop()) context.error(GL_STACK_UNDERFLOW);
}

} // namespace ffgpu::gl::api
