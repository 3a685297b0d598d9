// Where vertex arrays lie, and which are in use (GL 1.5, 2.8).

#include "driver/commands/declarations.h"
#include "driver/context/context.h"
#include "driver/get/client_arrays.h"
#include "driver/vertex/array_gather.h"

#include <algorithm>
#include <initializer_list>

namespace ffgpu::gl::api {
namespace {

using Types = std::initializer_list<GLenum>;

struct Pointer {
    GLint size;
    GLenum type;
    GLsizei stride;
    const void* pointer;
    bool normalized = false; // integers stand for fractions
};

// The size is checked by the caller, whose commands differ in it.
void set_array(Context& context, VertexArray& array, Types types, const Pointer& to) {
    if (std::find(types.begin(), types.end(), to.type) == types.end())
        return context.error(GL_INVALID_ENUM);
    if (to.stride < 0) return context.error(GL_INVALID_VALUE);
    array.size = to.size;
    array.bgra = false;
    array.normalized = to.normalized;
    array.type = to.type;
    array.stride = to.stride;
    array.pointer = to.pointer;
    array.buffer = context.client.buffers.array;
}

VertexArray& array_of(Context& context, Attribute attribute) {
    return context.client.arrays.of(attribute);
}

// Colours may have the size GL_BGRA (EXT_vertex_array_bgra), in bytes alone.
void set_color_array(Context& context, Attribute attribute, GLint least_size, const Pointer& to) {
    VertexArray& array = array_of(context, attribute);
    const Types all = {GL_BYTE,
                       GL_UNSIGNED_BYTE,
                       GL_SHORT,
                       GL_UNSIGNED_SHORT,
                       GL_INT,
                       GL_UNSIGNED_INT,
                       GL_FLOAT,
                       GL_DOUBLE};
    if (to.size == GL_BGRA) {
        if (to.type != GL_UNSIGNED_BYTE) return context.error(GL_INVALID_VALUE);
        if (to.stride < 0) return context.error(GL_INVALID_VALUE);
        set_array(context, array, all, {4, to.type, to.stride, to.pointer, true});
        array.bgra = true;
        return;
    }
    if (to.size < least_size || to.size > 4) return context.error(GL_INVALID_VALUE);
    set_array(context, array, all, {to.size, to.type, to.stride, to.pointer, true});
}

void enable_array(Context& context, GLenum token, bool enable) {
    if (context.fails_inside_begin()) return;
    if (token == GL_PRIMITIVE_RESTART_NV) {
        context.client.arrays.primitive_restart = enable;
        return;
    }
    const VertexArray* const array = find_client_array(context.client.arrays, token);
    if (!array) return context.error(GL_INVALID_ENUM);
    const_cast<VertexArray*>(array)->enabled = enable; // The arrays are not const.
}

} // namespace

void VertexPointer(Context& context, GLint size, GLenum type, GLsizei stride, const void* pointer) {
    if (size < 2 || size > 4) return context.error(GL_INVALID_VALUE);
    set_array(context,
              array_of(context, Attribute::Position),
              {GL_SHORT, GL_INT, GL_FLOAT, GL_DOUBLE},
              {size, type, stride, pointer});
}

void NormalPointer(Context& context, GLenum type, GLsizei stride, const void* pointer) {
    set_array(context,
              array_of(context, Attribute::Normal),
              {GL_BYTE, GL_SHORT, GL_INT, GL_FLOAT, GL_DOUBLE},
              {3, type, stride, pointer, true});
}

void ColorPointer(Context& context, GLint size, GLenum type, GLsizei stride, const void* pointer) {
    set_color_array(context, Attribute::Color, 3, {size, type, stride, pointer});
}

void SecondaryColorPointer(
    Context& context, GLint size, GLenum type, GLsizei stride, const void* pointer) {
    if (size == 4) return context.error(GL_INVALID_VALUE);
    set_color_array(context, Attribute::SecondaryColor, 3, {size, type, stride, pointer});
}

void FogCoordPointer(Context& context, GLenum type, GLsizei stride, const void* pointer) {
    set_array(context,
              array_of(context, Attribute::FogCoordinate),
              {GL_FLOAT, GL_DOUBLE},
              {1, type, stride, pointer});
}

void IndexPointer(Context& context, GLenum type, GLsizei stride, const void* pointer) {
    set_array(context,
              context.client.arrays.object->color_index,
              {GL_UNSIGNED_BYTE, GL_SHORT, GL_INT, GL_FLOAT, GL_DOUBLE},
              {1, type, stride, pointer});
}

void EdgeFlagPointer(Context& context, GLsizei stride, const void* pointer) {
    set_array(context,
              array_of(context, Attribute::EdgeFlag),
              {GL_UNSIGNED_BYTE},
              {1, GL_UNSIGNED_BYTE, stride, pointer});
}

void TexCoordPointer(
    Context& context, GLint size, GLenum type, GLsizei stride, const void* pointer) {
    if (size < 1 || size > 4) return context.error(GL_INVALID_VALUE);
    set_array(context,
              array_of(context, tex_coord(context.client.arrays.active_unit)),
              {GL_SHORT, GL_INT, GL_FLOAT, GL_DOUBLE},
              {size, type, stride, pointer});
}

// EXT_vertex_array: the number of elements is a hint alone.

void VertexPointerEXT(
    Context& context, GLint size, GLenum type, GLsizei stride, GLsizei count, const void* pointer) {
    if (count < 0) return context.error(GL_INVALID_VALUE);
    VertexPointer(context, size, type, stride, pointer);
}

void NormalPointerEXT(
    Context& context, GLenum type, GLsizei stride, GLsizei count, const void* pointer) {
    if (count < 0) return context.error(GL_INVALID_VALUE);
    NormalPointer(context, type, stride, pointer);
}

void ColorPointerEXT(
    Context& context, GLint size, GLenum type, GLsizei stride, GLsizei count, const void* pointer) {
    if (count < 0) return context.error(GL_INVALID_VALUE);
    ColorPointer(context, size, type, stride, pointer);
}

void IndexPointerEXT(
    Context& context, GLenum type, GLsizei stride, GLsizei count, const void* pointer) {
    if (count < 0) return context.error(GL_INVALID_VALUE);
    IndexPointer(context, type, stride, pointer);
}

void EdgeFlagPointerEXT(Context& context, GLsizei stride, GLsizei count, const GLboolean* pointer) {
    if (count < 0) return context.error(GL_INVALID_VALUE);
    EdgeFlagPointer(context, stride, pointer);
}

void TexCoordPointerEXT(
    Context& context, GLint size, GLenum type, GLsizei stride, GLsizei count, const void* pointer) {
    if (count < 0) return context.error(GL_INVALID_VALUE);
    TexCoordPointer(context, size, type, stride, pointer);
}

void EnableClientState(Context& context, GLenum array) {
    enable_array(context, array, true);
}

void DisableClientState(Context& context, GLenum array) {
    enable_array(context, array, false);
}

void ClientActiveTexture(Context& context, GLenum texture) {
    const GLenum unit = texture - GL_TEXTURE0;
    if (unit >= TextureUnits) return context.error(GL_INVALID_ENUM);
    context.client.arrays.active_unit = unit;
}

// EXT_compiled_vertex_array: a promise that the arrays stay as they are. Nothing is gained by it
// here: what a draw uses is gathered once as it is.

void LockArraysEXT(Context& context, GLint first, GLsizei count) {
    VertexArrayState& arrays = context.client.arrays;
    if (first < 0 || count <= 0) return context.error(GL_INVALID_VALUE);
    if (arrays.lock_count != 0) return context.error(GL_INVALID_OPERATION);
    arrays.lock_first = first;
    arrays.lock_count = count;
}

void UnlockArraysEXT(Context& context) {
    VertexArrayState& arrays = context.client.arrays;
    if (arrays.lock_count == 0) return context.error(GL_INVALID_OPERATION);
    arrays.lock_first = 0;
    arrays.lock_count = 0;
}

} // namespace ffgpu::gl::api
