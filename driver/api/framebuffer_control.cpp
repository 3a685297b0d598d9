// Selecting buffers and masking writes (GL 1.5, 4.2.1, 4.2.2 and 4.3.2).

#include "driver/context/context.h"
#include "driver/entry_points/declarations.h"
#include "driver/framebuffer/drawable.h"
#include "driver/objects/framebuffer_object.h"

namespace ffgpu::gl::api {
namespace {

bool is_color_attachment(GLenum buffer) {
    return buffer >= GL_COLOR_ATTACHMENT0 && buffer <= GL_COLOR_ATTACHMENT31;
}

bool is_window_buffer(GLenum buffer) {
    return (buffer >= GL_FRONT_LEFT && buffer <= GL_FRONT_AND_BACK) ||
           (buffer >= GL_AUX0 && buffer <= GL_AUX3);
}

// There is neither a right nor an auxiliary buffer, and a back buffer only where the drawable has
// one.
bool exists(Drawable* drawable, GLenum buffer) {
    switch (buffer) {
    case GL_FRONT:
    case GL_FRONT_LEFT:
    case GL_LEFT:
    case GL_FRONT_AND_BACK:
        return true;
    case GL_BACK:
    case GL_BACK_LEFT:
        return !drawable || drawable->format().double_buffer;
    default:
        return false;
    }
}

// The error of selecting `buffer` of a window or of a framebuffer object, or GL_NO_ERROR.
GLenum selection_error(Drawable* drawable, const FramebufferObject* object, GLenum buffer) {
    if (!is_color_attachment(buffer) && !is_window_buffer(buffer)) return GL_INVALID_ENUM;
    const bool found =
        object ? is_color_attachment(buffer) && buffer < GL_COLOR_ATTACHMENT0 + MaxColorAttachments
               : exists(drawable, buffer);
    return found ? GL_NO_ERROR : GL_INVALID_OPERATION;
}

} // namespace

void DrawBuffer(Context& context, GLenum buf) {
    FramebufferState& framebuffer = context.state.framebuffer;
    FramebufferObject* const object = framebuffer.draw_object.get();
    if (buf != GL_NONE) {
        const GLenum error = selection_error(context.draw_drawable(), object, buf);
        if (error != GL_NO_ERROR) return context.error(error);
    }
    (object ? object->draw_buffer : framebuffer.draw_buffer) = buf;
    context.dirty.mark(Dirty::Targets);
}

void ReadBuffer(Context& context, GLenum src) {
    FramebufferState& framebuffer = context.state.framebuffer;
    FramebufferObject* const object = framebuffer.read_object.get();
    if (src == GL_FRONT_AND_BACK) return context.error(GL_INVALID_ENUM);
    // EXT_framebuffer_object allows GL_NONE for its objects, ARB_framebuffer_object for windows
    // too.
    if (src != GL_NONE) {
        const GLenum error = selection_error(context.read_drawable(), object, src);
        if (error != GL_NO_ERROR) return context.error(error);
    }
    (object ? object->read_buffer : framebuffer.read_buffer) = src;
}

void ColorMask(Context& context, GLboolean red, GLboolean green, GLboolean blue, GLboolean alpha) {
    context.state.framebuffer.color_mask = {red != 0, green != 0, blue != 0, alpha != 0};
    context.dirty.mark(Dirty::Fragment);
}

// There are no colour-index buffers; the state is GL's all the same.
void IndexMask(Context& context, GLuint mask) {
    context.state.framebuffer.index_mask = mask;
}

void DepthMask(Context& context, GLboolean flag) {
    context.state.fragment.depth.write_mask = flag != GL_FALSE;
    context.dirty.mark(Dirty::Fragment);
}

} // namespace ffgpu::gl::api
