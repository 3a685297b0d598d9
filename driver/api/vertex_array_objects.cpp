// Vertex array objects (ARB_vertex_array_object, APPLE_vertex_array_object). They are the
// context's own, not shared.

#include "driver/commands/declarations.h"
#include "driver/context/context.h"

namespace ffgpu::gl::api {
namespace {

std::shared_ptr<VertexArrayObject> make_object(GLuint name) {
    auto object = std::make_shared<VertexArrayObject>();
    object->name = name;
    return object;
}

} // namespace

void GenVertexArrays(Context& context, GLsizei n, GLuint* arrays) {
    if (context.fails_inside_begin()) return;
    if (n < 0) return context.error(GL_INVALID_VALUE);
    context.vertex_array_objects.generate({arrays, static_cast<std::size_t>(n)});
}

void DeleteVertexArrays(Context& context, GLsizei n, const GLuint* arrays) {
    if (context.fails_inside_begin()) return;
    if (n < 0) return context.error(GL_INVALID_VALUE);
    for (GLsizei i = 0; i < n; ++i) {
        if (arrays[i] == 0) continue;
        if (context.client.arrays.object->name == arrays[i])
            context.client.arrays.object = context.default_vertex_array_object;
        context.vertex_array_objects.remove(arrays[i]);
    }
}

void BindVertexArray(Context& context, GLuint array) {
    if (context.fails_inside_begin()) return;
    if (array == 0) {
        context.client.arrays.object = context.default_vertex_array_object;
        return;
    }
    auto& objects = context.vertex_array_objects;
    if (!objects.is_used(array)) return context.error(GL_INVALID_OPERATION);
    if (!objects.find(array)) objects.set(array, make_object(array));
    context.client.arrays.object = objects.share(array);
}

// APPLE's makes the name an object's if it is not yet.
void BindVertexArrayAPPLE(Context& context, GLuint array) {
    if (context.fails_inside_begin()) return;
    if (array != 0) context.vertex_array_objects.reserve(array);
    BindVertexArray(context, array);
}

GLboolean IsVertexArray(Context& context, GLuint array) {
    if (context.fails_inside_begin()) return GL_FALSE;
    return context.vertex_array_objects.find(array) ? GL_TRUE : GL_FALSE;
}

} // namespace ffgpu::gl::api
