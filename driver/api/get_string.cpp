// glGetString (GL 1.5, 6.1.11).

#include "driver/commands/declarations.h"
#include "driver/context/context.h"
#include "driver/context/extensions.h"

namespace ffgpu::gl::api {
namespace {

const GLubyte* as_gl(const char* text) {
    return reinterpret_cast<const GLubyte*>(text);
}

} // namespace

const GLubyte* GetString(Context& context, GLenum name) {
    switch (name) {
    case GL_VENDOR:
        return as_gl("ffgpu");
    case GL_RENDERER:
        return as_gl("ffgpu fixed-function GPU");
    case GL_VERSION:
        return as_gl("1.5 ffgpu " FFGPU_VERSION);
    case GL_EXTENSIONS:
        return as_gl(extension_string());
    default:
        context.error(GL_INVALID_ENUM);
        return nullptr;
    }
}

} // namespace ffgpu::gl::api
