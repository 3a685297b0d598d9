// Buffer objects (GL 1.5, 2.9; ARB_pixel_buffer_object, ARB_copy_buffer).

#include "driver/api/buffer_target.h"
#include "driver/commands/declarations.h"
#include "driver/context/context.h"
#include "driver/objects/buffer_object.h"
#include "driver/objects/shared_objects.h"

#include <algorithm>
#include <cstring>

namespace ffgpu::gl::api {
namespace {

bool is_usage(GLenum usage) {
    switch (usage) {
    case GL_STREAM_DRAW:
    case GL_STREAM_READ:
    case GL_STREAM_COPY:
    case GL_STATIC_DRAW:
    case GL_STATIC_READ:
    case GL_STATIC_COPY:
    case GL_DYNAMIC_DRAW:
    case GL_DYNAMIC_READ:
    case GL_DYNAMIC_COPY:
        return true;
    default:
        return false;
    }
}

void unbind(VertexArrayObject& object, const BufferObject* buffer) {
    const auto drop = [buffer](std::shared_ptr<BufferObject>& binding) {
        if (binding.get() == buffer) binding = nullptr;
    };
    for (VertexArray& array : object.arrays)
        drop(array.buffer);
    drop(object.color_index.buffer);
    drop(object.element_buffer);
}

// The bindings of this context become 0 (GL 1.5, 2.9); the bound vertex array object's too, others
// keep the buffer alive.
void unbind_everywhere(Context& context, const BufferObject* buffer) {
    BufferState& bound = context.client.buffers;
    for (auto* binding : {&bound.array,
                          &bound.pixel_pack,
                          &bound.pixel_unpack,
                          &bound.copy_read,
                          &bound.copy_write}) {
        if (binding->get() == buffer) *binding = nullptr;
    }
    unbind(*context.client.arrays.object, buffer);
}

// The buffer at `target` for an access to `size` bytes from `offset` on; null, with the error
// recorded, if there is none or they do not lie in it.
BufferObject* accessible_buffer(Context& context, GLenum target, GLintptr offset, GLsizeiptr size) {
    BufferObject* const buffer = bound_buffer(context, target);
    if (!buffer) return nullptr;
    if (offset < 0 || size < 0 ||
        !buffer->contains(static_cast<std::size_t>(offset), static_cast<std::size_t>(size)))
        return context.error(GL_INVALID_VALUE), nullptr;
    if (buffer->mapped) return context.error(GL_INVALID_OPERATION), nullptr;
    return buffer;
}

} // namespace

void GenBuffers(Context& context, GLsizei n, GLuint* buffers) {
    if (context.fails_inside_begin()) return;
    if (n < 0) return context.error(GL_INVALID_VALUE);
    context.shared().buffers.generate({buffers, static_cast<std::size_t>(n)});
}

void DeleteBuffers(Context& context, GLsizei n, const GLuint* buffers) {
    if (context.fails_inside_begin()) return;
    if (n < 0) return context.error(GL_INVALID_VALUE);
    for (GLsizei i = 0; i < n; ++i) {
        const std::shared_ptr<BufferObject> buffer = context.shared().buffers.remove(buffers[i]);
        if (!buffer) continue;
        buffer->unmap();
        unbind_everywhere(context, buffer.get());
    }
}

GLboolean IsBuffer(Context& context, GLuint buffer) {
    if (context.fails_inside_begin()) return GL_FALSE;
    return context.shared().buffers.find(buffer) ? GL_TRUE : GL_FALSE;
}

void BindBuffer(Context& context, GLenum target, GLuint buffer) {
    if (context.fails_inside_begin()) return;
    std::shared_ptr<BufferObject>* const binding = buffer_binding(context, target);
    if (!binding) return context.error(GL_INVALID_ENUM);
    auto& buffers = context.shared().buffers;
    if (buffer != 0 && !buffers.find(buffer))
        buffers.set(buffer, std::make_shared<BufferObject>(buffer));
    *binding = buffers.share(buffer);
}

void BufferData(Context& context, GLenum target, GLsizeiptr size, const void* data, GLenum usage) {
    if (context.fails_inside_begin()) return;
    if (buffer_binding(context, target) && !is_usage(usage)) return context.error(GL_INVALID_ENUM);
    BufferObject* const buffer = bound_buffer(context, target);
    if (!buffer) return;
    if (size < 0) return context.error(GL_INVALID_VALUE);
    if (size > MaxBufferBytes) return context.error(GL_OUT_OF_MEMORY);
    buffer->allocate(static_cast<std::size_t>(size), data);
    buffer->unmap();
    buffer->usage = usage;
}

void BufferSubData(
    Context& context, GLenum target, GLintptr offset, GLsizeiptr size, const void* data) {
    if (context.fails_inside_begin()) return;
    BufferObject* const buffer = accessible_buffer(context, target, offset, size);
    if (buffer && size != 0)
        std::memcpy(buffer->bytes().data() + offset, data, static_cast<std::size_t>(size));
}

void GetBufferSubData(
    Context& context, GLenum target, GLintptr offset, GLsizeiptr size, void* data) {
    if (context.fails_inside_begin()) return;
    const BufferObject* const buffer = accessible_buffer(context, target, offset, size);
    if (buffer && size != 0)
        std::memcpy(data, buffer->bytes().data() + offset, static_cast<std::size_t>(size));
}

void CopyBufferSubData(Context& context,
                       GLenum readTarget,
                       GLenum writeTarget,
                       GLintptr readOffset,
                       GLintptr writeOffset,
                       GLsizeiptr size) {
    if (context.fails_inside_begin()) return;
    const BufferObject* const from = accessible_buffer(context, readTarget, readOffset, size);
    if (!from) return;
    BufferObject* const to = accessible_buffer(context, writeTarget, writeOffset, size);
    if (!to) return;
    const bool overlap =
        from == to && readOffset < writeOffset + size && writeOffset < readOffset + size;
    if (overlap) return context.error(GL_INVALID_VALUE);
    if (size != 0)
        std::memcpy(to->bytes().data() + writeOffset,
                    from->bytes().data() + readOffset,
                    static_cast<std::size_t>(size));
}

void GetBufferParameteriv(Context& context, GLenum target, GLenum pname, GLint* params) {
    if (context.fails_inside_begin()) return;
    const BufferObject* const buffer = bound_buffer(context, target);
    if (!buffer) return;
    switch (pname) {
    case GL_BUFFER_SIZE:
        *params = static_cast<GLint>(buffer->size());
        break;
    case GL_BUFFER_USAGE:
        *params = static_cast<GLint>(buffer->usage);
        break;
    case GL_BUFFER_ACCESS:
        *params = static_cast<GLint>(buffer->access);
        break;
    case GL_BUFFER_ACCESS_FLAGS:
        *params = static_cast<GLint>(buffer->map_access);
        break;
    case GL_BUFFER_MAPPED:
        *params = buffer->mapped ? GL_TRUE : GL_FALSE;
        break;
    case GL_BUFFER_MAP_OFFSET:
        *params = static_cast<GLint>(buffer->map_offset);
        break;
    case GL_BUFFER_MAP_LENGTH:
        *params = static_cast<GLint>(buffer->map_length);
        break;
    default:
        context.error(GL_INVALID_ENUM);
    }
}

} // namespace ffgpu::gl::api
