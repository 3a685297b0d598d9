// Selection and feedback (GL 1.5, 5.2 and 5.3).

#include "driver/commands/declarations.h"
#include "driver/context/context.h"
#include "driver/feedback/render_modes.h"
#include "driver/limits.h"

namespace ffgpu::gl::api {

GLint RenderMode(Context& context, GLenum mode) {
    if (context.fails_inside_begin()) return 0;
    RenderModes& modes = context.render_modes();
    if (mode != GL_RENDER && mode != GL_SELECT && mode != GL_FEEDBACK)
        return context.error(GL_INVALID_ENUM), 0;
    const bool has_buffer = mode == GL_SELECT     ? modes.selection.buffer() != nullptr
                            : mode == GL_FEEDBACK ? modes.feedback.buffer() != nullptr
                                                  : true;
    if (!has_buffer) return context.error(GL_INVALID_OPERATION), 0;
    return modes.change_mode(mode);
}

void SelectBuffer(Context& context, GLsizei size, GLuint* buffer) {
    if (context.fails_inside_begin()) return;
    if (size < 0) return context.error(GL_INVALID_VALUE);
    if (context.render_modes().mode() == GL_SELECT) return context.error(GL_INVALID_OPERATION);
    context.render_modes().selection.set_buffer(buffer, size);
}

void FeedbackBuffer(Context& context, GLsizei size, GLenum type, GLfloat* buffer) {
    if (context.fails_inside_begin()) return;
    const bool is_type = type == GL_2D || type == GL_3D || type == GL_3D_COLOR ||
                         type == GL_3D_COLOR_TEXTURE || type == GL_4D_COLOR_TEXTURE;
    if (!is_type) return context.error(GL_INVALID_ENUM);
    if (size < 0) return context.error(GL_INVALID_VALUE);
    if (context.render_modes().mode() == GL_FEEDBACK) return context.error(GL_INVALID_OPERATION);
    context.render_modes().feedback.set_buffer(buffer, size, type);
}

// The commands of the name stack are ignored outside of selection mode.

void InitNames(Context& context) {
    if (context.fails_inside_begin()) return;
    if (context.render_modes().mode() == GL_SELECT) context.render_modes().selection.init_names();
}

void LoadName(Context& context, GLuint name) {
    if (context.fails_inside_begin()) return;
    if (context.render_modes().mode() != GL_SELECT) return;
    Selection& selection = context.render_modes().selection;
    if (selection.names().empty()) return context.error(GL_INVALID_OPERATION);
    selection.load_name(name);
}

void PushName(Context& context, GLuint name) {
    if (context.fails_inside_begin()) return;
    if (context.render_modes().mode() != GL_SELECT) return;
    Selection& selection = context.render_modes().selection;
    if (selection.names().size() >= NameStackDepth) return context.error(GL_STACK_OVERFLOW);
    selection.push_name(name);
}

void PopName(Context& context) {
    if (context.fails_inside_begin()) return;
    if (context.render_modes().mode() != GL_SELECT) return;
    Selection& selection = context.render_modes().selection;
    if (selection.names().empty()) return context.error(GL_STACK_UNDERFLOW);
    selection.pop_name();
}

void PassThrough(Context& context, GLfloat token) {
    if (context.fails_inside_begin()) return;
    if (context.render_modes().mode() == GL_FEEDBACK)
        context.render_modes().feedback.pass_through(token);
}

} // namespace ffgpu::gl::api
