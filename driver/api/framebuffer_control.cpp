// Selecting buffers and masking writes (GL 1.5, 4.2.1, 4.2.2 and 4.3.2).

#include "driver/commands/declarations.h"
#include "driver/context/context.h"
#include "driver/framebuffer/drawable.h"
#include "driver/objects/framebuffer_object.h"

#include <algorithm>
#include <span>

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

// Tokens that may stand for several buffers are glDrawBuffer's alone (ARB_draw_buffers).
bool is_several_buffers(GLenum buffer) {
    return buffer == GL_FRONT || buffer == GL_BACK || buffer == GL_LEFT || buffer == GL_RIGHT ||
           buffer == GL_FRONT_AND_BACK;
}

// The error of glDrawBuffers(buffers), or GL_NO_ERROR.
GLenum list_error(Context& context, std::span<const GLenum> buffers) {
    const FramebufferObject* const object = context.state.framebuffer.draw_object.get();
    for (const GLenum& buffer : buffers) {
        if (buffer == GL_NONE) continue;
        if (is_several_buffers(buffer)) return GL_INVALID_OPERATION;
        const GLenum error = selection_error(context.draw_drawable(), object, buffer);
        if (error != GL_NO_ERROR) return error;
        if (std::find(buffers.data(), &buffer, buffer) != &buffer) return GL_INVALID_OPERATION;
    }
    return GL_NO_ERROR;
}

void select(Context& context, const DrawBufferList& buffers) {
    FramebufferState& framebuffer = context.state.framebuffer;
    FramebufferObject* const object = framebuffer.draw_object.get();
    (object ? object->draw_buffers : framebuffer.draw_buffers) = buffers;
    context.dirty.mark(Dirty::Targets);
}

} // namespace

void DrawBuffer(Context& context, GLenum buf) {
    const FramebufferObject* const object = context.state.framebuffer.draw_object.get();
    if (buf != GL_NONE) {
        const GLenum error = selection_error(context.draw_drawable(), object, buf);
        if (error != GL_NO_ERROR) return context.error(error);
    }
    select(context, {buf});
}

void DrawBuffers(Context& context, GLsizei n, const GLenum* bufs) {
    if (n < 0 || n > GLsizei{ColorTargets}) return context.error(GL_INVALID_VALUE);
    const std::span buffers(bufs, static_cast<std::size_t>(n));
    if (const GLenum error = list_error(context, buffers)) return context.error(error);
    DrawBufferList selected{};
    std::copy(buffers.begin(), buffers.end(), selected.begin());
    select(context, selected);
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
