// The commands that draw from vertex arrays (GL 1.5, 2.8).

#include "driver/commands/declarations.h"
#include "driver/context/context.h"
#include "driver/vertex/array_draws.h"

#include <algorithm>
#include <span>

namespace ffgpu::gl::api {
namespace {

// One bad count refuses all draws: a command that errs has no effect (GL 1.5, 2.5).
bool can_draw_all(Context& context, const GLsizei* count, GLsizei draws) {
    const auto is_bad = [](GLsizei n) { return n < 0; };
    if (draws >= 0) {
        const std::span counts(count, static_cast<std::size_t>(draws));
        if (std::none_of(counts.begin(), counts.end(), is_bad)) return true;
    }
    context.error(GL_INVALID_VALUE);
    return false;
}

} // namespace

void ArrayElement(Context& context, GLint i) {
    array_element(context, i);
}

void DrawArrays(Context& context, GLenum mode, GLint first, GLsizei count) {
    draw_arrays(context, mode, first, count);
}

void MultiDrawArrays(
    Context& context, GLenum mode, const GLint* first, const GLsizei* count, GLsizei drawcount) {
    if (!can_draw_all(context, count, drawcount)) return;
    for (GLsizei i = 0; i < drawcount; ++i)
        draw_arrays(context, mode, first[i], count[i]);
}

void DrawElements(Context& context, GLenum mode, GLsizei count, GLenum type, const void* indices) {
    draw_elements(context, mode, count, type, indices);
}

void DrawElementsBaseVertex(Context& context,
                            GLenum mode,
                            GLsizei count,
                            GLenum type,
                            const void* indices,
                            GLint basevertex) {
    draw_elements(context, mode, count, type, indices, basevertex);
}

// The range is a promise that draws need not rely on: what the indices say is gathered.
void DrawRangeElementsBaseVertex(Context& context,
                                 GLenum mode,
                                 GLuint start,
                                 GLuint end,
                                 GLsizei count,
                                 GLenum type,
                                 const void* indices,
                                 GLint basevertex) {
    if (end < start) return context.error(GL_INVALID_VALUE);
    draw_elements(context, mode, count, type, indices, basevertex);
}

void DrawRangeElements(Context& context,
                       GLenum mode,
                       GLuint start,
                       GLuint end,
                       GLsizei count,
                       GLenum type,
                       const void* indices) {
    DrawRangeElementsBaseVertex(context, mode, start, end, count, type, indices, 0);
}

// Nothing in a fixed-function pipeline tells one instance from another.
void DrawElementsInstancedBaseVertex(Context& context,
                                     GLenum mode,
                                     GLsizei count,
                                     GLenum type,
                                     const void* indices,
                                     GLsizei instancecount,
                                     GLint basevertex) {
    if (instancecount < 0) return context.error(GL_INVALID_VALUE);
    for (GLsizei i = 0; i < instancecount; ++i)
        draw_elements(context, mode, count, type, indices, basevertex);
}

void MultiDrawElements(Context& context,
                       GLenum mode,
                       const GLsizei* count,
                       GLenum type,
                       const void* const* indices,
                       GLsizei drawcount) {
    if (!can_draw_all(context, count, drawcount)) return;
    for (GLsizei i = 0; i < drawcount; ++i)
        draw_elements(context, mode, count[i], type, indices[i]);
}

void MultiDrawElementsBaseVertex(Context& context,
                                 GLenum mode,
                                 const GLsizei* count,
                                 GLenum type,
                                 const void* const* indices,
                                 GLsizei drawcount,
                                 const GLint* basevertex) {
    if (!can_draw_all(context, count, drawcount)) return;
    for (GLsizei i = 0; i < drawcount; ++i)
        draw_elements(context, mode, count[i], type, indices[i], basevertex[i]);
}

} // namespace ffgpu::gl::api
