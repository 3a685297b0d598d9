// The targets of glBindBuffer.

#pragma once

#include "driver/context/context.h"
#include "driver/objects/buffer_object.h"

#include <memory>

namespace ffgpu::gl {

// A buffer larger than this is GL_OUT_OF_MEMORY.
constexpr GLsizeiptr MaxBufferBytes = GLsizeiptr{1} << 31;

// Null: there is no such target.
inline std::shared_ptr<BufferObject>* buffer_binding(Context& context, GLenum target) {
    BufferState& buffers = context.client.buffers;
    switch (target) {
    case GL_ARRAY_BUFFER:
        return &buffers.array;
    case GL_ELEMENT_ARRAY_BUFFER:
        return &context.client.arrays.object->element_buffer;
    case GL_PIXEL_PACK_BUFFER:
        return &buffers.pixel_pack;
    case GL_PIXEL_UNPACK_BUFFER:
        return &buffers.pixel_unpack;
    case GL_COPY_READ_BUFFER:
        return &buffers.copy_read;
    case GL_COPY_WRITE_BUFFER:
        return &buffers.copy_write;
    default:
        return nullptr;
    }
}

// The buffer bound to `target`; null, with the error recorded, if there is none.
inline BufferObject* bound_buffer(Context& context, GLenum target) {
    const std::shared_ptr<BufferObject>* const binding = buffer_binding(context, target);
    if (!binding) return context.error(GL_INVALID_ENUM), nullptr;
    if (!*binding) return context.error(GL_INVALID_OPERATION), nullptr;
    return binding->get();
}

} // namespace ffgpu::gl
