// Display lists (GL 1.5, 5.4).

#include "driver/commands/declarations.h"
#include "driver/context/context.h"
#include "driver/entry_points/list_player.h"
#include "driver/lists/array_length.h"
#include "driver/lists/list_compiler.h"
#include "driver/objects/shared_objects.h"

#include <cstring>

namespace ffgpu::gl::api {
namespace {

template <class T>
T read(const void* from, GLsizei i) {
    T value;
    std::memcpy(
        &value, static_cast<const std::byte*>(from) + std::size_t(i) * sizeof(T), sizeof(T));
    return value;
}

// Several bytes to a name, the most significant first.
GLuint read_bytes(const void* from, GLsizei i, unsigned bytes) {
    const auto* at = static_cast<const GLubyte*>(from) + std::size_t(i) * bytes;
    GLuint value = 0;
    for (unsigned b = 0; b < bytes; ++b)
        value = value << 8 | at[b];
    return value;
}

// Name i of glCallLists, before the base is added; signed ones are offsets to below the base.
GLuint list_offset(const void* lists, GLenum type, GLsizei i) {
    switch (type) {
    case GL_BYTE:
        return static_cast<GLuint>(read<GLbyte>(lists, i));
    case GL_UNSIGNED_BYTE:
        return read<GLubyte>(lists, i);
    case GL_SHORT:
        return static_cast<GLuint>(read<GLshort>(lists, i));
    case GL_UNSIGNED_SHORT:
        return read<GLushort>(lists, i);
    case GL_INT:
        return static_cast<GLuint>(read<GLint>(lists, i));
    case GL_UNSIGNED_INT:
        return read<GLuint>(lists, i);
    case GL_FLOAT: {
        const float value = read<GLfloat>(lists, i);
        if (!(value > -2147483648.0f && value < 4294967296.0f)) return 0;
        return static_cast<GLuint>(static_cast<std::int64_t>(value));
    }
    default:
        return read_bytes(lists, i, list_name_bytes(type));
    }
}

} // namespace

void NewList(Context& context, GLuint list, GLenum mode) {
    if (context.fails_inside_begin()) return;
    if (list == 0) return context.error(GL_INVALID_VALUE);
    if (mode != GL_COMPILE && mode != GL_COMPILE_AND_EXECUTE) return context.error(GL_INVALID_ENUM);
    if (context.lists().compiling()) return context.error(GL_INVALID_OPERATION);
    context.lists().begin(list, mode);
}

void EndList(Context& context) {
    if (context.fails_inside_begin()) return;
    if (!context.lists().compiling()) return context.error(GL_INVALID_OPERATION);
    context.lists().end();
}

void CallList(Context& context, GLuint list) {
    if (list == 0) return context.error(GL_INVALID_VALUE);
    call_list(context, list);
}

void CallLists(Context& context, GLsizei n, GLenum type, const void* lists) {
    if (list_name_bytes(type) == 0) return context.error(GL_INVALID_ENUM);
    if (n < 0) return context.error(GL_INVALID_VALUE);
    for (GLsizei i = 0; i < n; ++i)
        call_list(context, context.lists().base + list_offset(lists, type, i));
}

void ListBase(Context& context, GLuint base) {
    if (context.fails_inside_begin()) return;
    context.lists().base = base;
}

GLuint GenLists(Context& context, GLsizei range) {
    if (context.fails_inside_begin()) return 0;
    if (range < 0) return context.error(GL_INVALID_VALUE), 0;
    if (range == 0) return 0;
    auto& lists = context.shared().lists;
    const auto count = static_cast<GLuint>(range);
    const GLuint first = lists.generate_range(count);
    // Each has an empty list: glIsList knows them.
    for (GLuint i = 0; first != 0 && i < count; ++i)
        lists.set(first + i, std::make_shared<DisplayList>());
    return first;
}

void DeleteLists(Context& context, GLuint list, GLsizei range) {
    if (context.fails_inside_begin()) return;
    if (range < 0) return context.error(GL_INVALID_VALUE);
    context.shared().lists.remove_range(list, static_cast<GLuint>(range));
}

GLboolean IsList(Context& context, GLuint list) {
    if (context.fails_inside_begin()) return GL_FALSE;
    return context.shared().lists.is_used(list) ? GL_TRUE : GL_FALSE;
}

} // namespace ffgpu::gl::api
