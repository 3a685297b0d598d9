// User clip planes (GL 1.5, 2.12).

#include "driver/commands/declarations.h"
#include "driver/context/context.h"
#include "driver/math/matrix.h"

namespace ffgpu::gl::api {
namespace {

bool is_clip_plane(GLenum plane) {
    return plane >= GL_CLIP_PLANE0 && plane < GL_CLIP_PLANE0 + ClipPlanes;
}

} // namespace

void ClipPlane(Context& context, GLenum plane, const GLdouble* equation) {
    if (!is_clip_plane(plane)) return context.error(GL_INVALID_ENUM);
    Vec4 object_plane;
    for (std::size_t i = 0; i < 4; ++i)
        object_plane[i] = static_cast<float>(equation[i]);
    TransformState& transform = context.state.transform;
    transform.group.clip_planes[plane - GL_CLIP_PLANE0] =
        transform_plane(object_plane, inverse(transform.matrices.model_view.top()));
    context.dirty.mark(Dirty::ClipPlanes);
}

void GetClipPlane(Context& context, GLenum plane, GLdouble* equation) {
    if (!is_clip_plane(plane)) return context.error(GL_INVALID_ENUM);
    const Vec4& eye_plane = context.state.transform.group.clip_planes[plane - GL_CLIP_PLANE0];
    for (std::size_t i = 0; i < 4; ++i)
        equation[i] = static_cast<double>(eye_plane[i]);
}

} // namespace ffgpu::gl::api
