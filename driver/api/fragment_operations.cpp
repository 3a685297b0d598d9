// Per-fragment tests (GL 1.5, 4.1.2 to 4.1.6), with EXT_stencil_two_side, ATI_separate_stencil and
// EXT_depth_bounds_test.

#include "driver/commands/declarations.h"
#include "driver/context/context.h"
#include "driver/math/conversion.h"

namespace ffgpu::gl::api {
namespace {

bool is_comparison(GLenum func) {
    return func >= GL_NEVER && func <= GL_ALWAYS;
}

bool is_stencil_operation(GLenum operation) {
    switch (operation) {
    case GL_KEEP:
    case GL_ZERO:
    case GL_REPLACE:
    case GL_INCR:
    case GL_DECR:
    case GL_INVERT:
    case GL_INCR_WRAP:
    case GL_DECR_WRAP:
        return true;
    default:
        return false;
    }
}

bool is_face(GLenum face) {
    return face == GL_FRONT || face == GL_BACK || face == GL_FRONT_AND_BACK;
}

// The faces that glStencilFunc, glStencilOp and glStencilMask act on: the active face of
// EXT_stencil_two_side; as the front face it stands for ATI_separate_stencil's pair.
template <class Change>
void change_active_faces(Context& context, Change change) {
    StencilState& stencil = context.state.fragment.stencil;
    if (stencil.active_face == GL_BACK) {
        change(stencil.two_side_back);
    } else {
        change(stencil.front);
        change(stencil.back);
    }
    context.dirty.mark(Dirty::Fragment);
}

void set_operations(StencilFaceState& face, GLenum fail, GLenum depth_fail, GLenum depth_pass) {
    face.fail = fail;
    face.depth_fail = depth_fail;
    face.depth_pass = depth_pass;
}

} // namespace

void Scissor(Context& context, GLint x, GLint y, GLsizei width, GLsizei height) {
    if (width < 0 || height < 0) return context.error(GL_INVALID_VALUE);
    ScissorState& scissor = context.state.fragment.scissor;
    scissor = {.enable = scissor.enable, .x = x, .y = y, .width = width, .height = height};
    context.dirty.mark(Dirty::Viewport);
}

void AlphaFunc(Context& context, GLenum func, GLfloat ref) {
    if (!is_comparison(func)) return context.error(GL_INVALID_ENUM);
    AlphaTestState& test = context.state.fragment.alpha_test;
    test.func = func;
    test.reference = clamp_unit(ref);
    context.dirty.mark(Dirty::Fragment);
}

void StencilFunc(Context& context, GLenum func, GLint ref, GLuint mask) {
    if (!is_comparison(func)) return context.error(GL_INVALID_ENUM);
    change_active_faces(context, [&](StencilFaceState& face) {
        face.func = func;
        face.reference = ref;
        face.compare_mask = mask;
    });
}

void StencilOp(Context& context, GLenum fail, GLenum zfail, GLenum zpass) {
    for (const GLenum operation : {fail, zfail, zpass}) {
        if (!is_stencil_operation(operation)) return context.error(GL_INVALID_ENUM);
    }
    change_active_faces(context,
                        [&](StencilFaceState& face) { set_operations(face, fail, zfail, zpass); });
}

void StencilMask(Context& context, GLuint mask) {
    change_active_faces(context, [&](StencilFaceState& face) { face.write_mask = mask; });
}

void StencilFuncSeparateATI(
    Context& context, GLenum frontfunc, GLenum backfunc, GLint ref, GLuint mask) {
    if (!is_comparison(frontfunc) || !is_comparison(backfunc))
        return context.error(GL_INVALID_ENUM);
    StencilState& stencil = context.state.fragment.stencil;
    stencil.front.func = frontfunc;
    stencil.back.func = backfunc;
    stencil.front.reference = stencil.back.reference = ref;
    stencil.front.compare_mask = stencil.back.compare_mask = mask;
    context.dirty.mark(Dirty::Fragment);
}

void StencilOpSeparateATI(
    Context& context, GLenum face, GLenum sfail, GLenum dpfail, GLenum dppass) {
    if (!is_face(face)) return context.error(GL_INVALID_ENUM);
    for (const GLenum operation : {sfail, dpfail, dppass}) {
        if (!is_stencil_operation(operation)) return context.error(GL_INVALID_ENUM);
    }
    StencilState& stencil = context.state.fragment.stencil;
    if (face != GL_BACK) set_operations(stencil.front, sfail, dpfail, dppass);
    if (face != GL_FRONT) set_operations(stencil.back, sfail, dpfail, dppass);
    context.dirty.mark(Dirty::Fragment);
}

void ActiveStencilFaceEXT(Context& context, GLenum face) {
    if (face != GL_FRONT && face != GL_BACK) return context.error(GL_INVALID_ENUM);
    context.state.fragment.stencil.active_face = face;
}

void DepthFunc(Context& context, GLenum func) {
    if (!is_comparison(func)) return context.error(GL_INVALID_ENUM);
    context.state.fragment.depth.func = func;
    context.dirty.mark(Dirty::Fragment);
}

void DepthBoundsEXT(Context& context, GLclampd zmin, GLclampd zmax) {
    zmin = clamp_unit(zmin);
    zmax = clamp_unit(zmax);
    if (zmin > zmax) return context.error(GL_INVALID_VALUE);
    DepthState& depth = context.state.fragment.depth;
    depth.bounds_min = zmin;
    depth.bounds_max = zmax;
    context.dirty.mark(Dirty::Fragment);
}

} // namespace ffgpu::gl::api
