// Hints (GL 1.5, 5.6).

#include "driver/commands/declarations.h"
#include "driver/context/context.h"

namespace ffgpu::gl::api {
namespace {

GLenum* find_hint(HintState& hints, GLenum target) {
    switch (target) {
    case GL_PERSPECTIVE_CORRECTION_HINT:
        return &hints.perspective_correction;
    case GL_POINT_SMOOTH_HINT:
        return &hints.point_smooth;
    case GL_LINE_SMOOTH_HINT:
        return &hints.line_smooth;
    case GL_POLYGON_SMOOTH_HINT:
        return &hints.polygon_smooth;
    case GL_FOG_HINT:
        return &hints.fog;
    case GL_GENERATE_MIPMAP_HINT:
        return &hints.generate_mipmap;
    case GL_TEXTURE_COMPRESSION_HINT:
        return &hints.texture_compression;
    default:
        return nullptr;
    }
}

} // namespace

void Hint(Context& context, GLenum target, GLenum mode) {
    GLenum* const hint = find_hint(context.state.hint, target);
    if (!hint) return context.error(GL_INVALID_ENUM);
    if (mode != GL_FASTEST && mode != GL_NICEST && mode != GL_DONT_CARE)
        return context.error(GL_INVALID_ENUM);
    *hint = mode;
}

} // namespace ffgpu::gl::api
