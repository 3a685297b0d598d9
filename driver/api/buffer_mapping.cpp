// Buffer objects in the application's address space (GL 1.5, 2.9.1; ARB_map_buffer_range).

#include "driver/api/buffer_target.h"
#include "driver/commands/declarations.h"
#include "driver/context/context.h"

namespace ffgpu::gl::api {
namespace {

constexpr GLbitfield AllAccess = GL_MAP_READ_BIT | GL_MAP_WRITE_BIT | GL_MAP_INVALIDATE_RANGE_BIT |
                                 GL_MAP_INVALIDATE_BUFFER_BIT | GL_MAP_FLUSH_EXPLICIT_BIT |
                                 GL_MAP_UNSYNCHRONIZED_BIT;

GLenum access_of(GLbitfield bits) {
    const bool read = (bits & GL_MAP_READ_BIT) != 0;
    const bool write = (bits & GL_MAP_WRITE_BIT) != 0;
    return read && write ? GL_READ_WRITE : read ? GL_READ_ONLY : GL_WRITE_ONLY;
}

// ARB_map_buffer_range's conditions on the access bits, INVALID_OPERATION where they are broken.
bool is_consistent(GLbitfield access) {
    constexpr GLbitfield NotWithRead =
        GL_MAP_INVALIDATE_RANGE_BIT | GL_MAP_INVALIDATE_BUFFER_BIT | GL_MAP_UNSYNCHRONIZED_BIT;
    if (!(access & (GL_MAP_READ_BIT | GL_MAP_WRITE_BIT))) return false;
    if ((access & GL_MAP_READ_BIT) && (access & NotWithRead)) return false;
    return (access & GL_MAP_WRITE_BIT) || !(access & GL_MAP_FLUSH_EXPLICIT_BIT);
}

void* map(BufferObject& buffer, std::size_t offset, std::size_t length, GLbitfield access) {
    buffer.mapped = true;
    buffer.access = access_of(access);
    buffer.map_access = access;
    buffer.map_offset = offset;
    buffer.map_length = length;
    return buffer.mapped_bytes();
}

} // namespace

void* MapBuffer(Context& context, GLenum target, GLenum access) {
    if (context.fails_inside_begin()) return nullptr;
    if (access != GL_READ_ONLY && access != GL_WRITE_ONLY && access != GL_READ_WRITE)
        return context.error(GL_INVALID_ENUM), nullptr;
    BufferObject* const buffer = bound_buffer(context, target);
    if (!buffer) return nullptr;
    if (buffer->mapped) return context.error(GL_INVALID_OPERATION), nullptr;
    const GLbitfield read = access != GL_WRITE_ONLY ? GL_MAP_READ_BIT : 0;
    const GLbitfield write = access != GL_READ_ONLY ? GL_MAP_WRITE_BIT : 0;
    return map(*buffer, 0, buffer->size(), read | write);
}

void* MapBufferRange(
    Context& context, GLenum target, GLintptr offset, GLsizeiptr length, GLbitfield access) {
    if (context.fails_inside_begin()) return nullptr;
    BufferObject* const buffer = bound_buffer(context, target);
    if (!buffer) return nullptr;
    const bool in_range =
        offset >= 0 && length >= 0 &&
        buffer->contains(static_cast<std::size_t>(offset), static_cast<std::size_t>(length));
    if (!in_range || (access & ~AllAccess)) return context.error(GL_INVALID_VALUE), nullptr;
    if (length == 0 || buffer->mapped || !is_consistent(access))
        return context.error(GL_INVALID_OPERATION), nullptr;
    return map(*buffer, static_cast<std::size_t>(offset), static_cast<std::size_t>(length), access);
}

// The data are in place at once: there is nothing to flush.
void FlushMappedBufferRange(Context& context, GLenum target, GLintptr offset, GLsizeiptr length) {
    if (context.fails_inside_begin()) return;
    const BufferObject* const buffer = bound_buffer(context, target);
    if (!buffer) return;
    if (!buffer->mapped || !(buffer->map_access & GL_MAP_FLUSH_EXPLICIT_BIT))
        return context.error(GL_INVALID_OPERATION);
    const auto mapped = static_cast<GLsizeiptr>(buffer->map_length);
    if (offset < 0 || length < 0 || offset > mapped || length > mapped - offset)
        context.error(GL_INVALID_VALUE);
}

GLboolean UnmapBuffer(Context& context, GLenum target) {
    if (context.fails_inside_begin()) return GL_FALSE;
    BufferObject* const buffer = bound_buffer(context, target);
    if (!buffer) return GL_FALSE;
    if (!buffer->mapped) return context.error(GL_INVALID_OPERATION), GL_FALSE;
    buffer->unmap();
    return GL_TRUE;
}

void GetBufferPointerv(Context& context, GLenum target, GLenum pname, void** params) {
    if (context.fails_inside_begin()) return;
    BufferObject* const buffer = bound_buffer(context, target);
    if (!buffer) return;
    if (pname != GL_BUFFER_MAP_POINTER) return context.error(GL_INVALID_ENUM);
    *params = buffer->mapped ? buffer->mapped_bytes() : nullptr;
}

} // namespace ffgpu::gl::api
