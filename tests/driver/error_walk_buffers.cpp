// Buffer objects.

#include "tests/driver/error_walk.h"

#include <array>

namespace ffgpu::gl::error_walk {
namespace {

constexpr GLenum Array = GL_ARRAY_BUFFER;

constexpr RefusedCall Unbound[] = {
    REFUSED(GL_INVALID_ENUM, BindBuffer, GL_TEXTURE_2D, 1),
    REFUSED(GL_INVALID_VALUE, GenBuffers, -1, names),
    REFUSED(GL_INVALID_VALUE, DeleteBuffers, -1, names),
    REFUSED(GL_INVALID_ENUM, BufferData, GL_TEXTURE_2D, 4, bytes, GL_STATIC_DRAW),
    REFUSED(GL_INVALID_OPERATION, BufferData, Array, 4, bytes, GL_STATIC_DRAW),
    REFUSED(GL_INVALID_ENUM, BufferSubData, GL_TEXTURE_2D, 0, 4, bytes),
    REFUSED(GL_INVALID_OPERATION, BufferSubData, Array, 0, 4, bytes),
    REFUSED(GL_INVALID_ENUM, GetBufferSubData, GL_TEXTURE_2D, 0, 4, bytes),
    REFUSED(GL_INVALID_OPERATION, GetBufferSubData, Array, 0, 4, bytes),
    REFUSED(GL_INVALID_ENUM, GetBufferParameteriv, GL_TEXTURE_2D, GL_BUFFER_SIZE, ints),
    REFUSED(GL_INVALID_OPERATION, GetBufferParameteriv, Array, GL_BUFFER_SIZE, ints),
    REFUSED(GL_INVALID_ENUM, GetBufferPointerv, GL_TEXTURE_2D, GL_BUFFER_MAP_POINTER, pointers),
    REFUSED(GL_INVALID_OPERATION, GetBufferPointerv, Array, GL_BUFFER_MAP_POINTER, pointers),
    REFUSED(GL_INVALID_ENUM, MapBuffer, GL_TEXTURE_2D, GL_READ_ONLY),
    REFUSED(GL_INVALID_OPERATION, MapBuffer, Array, GL_READ_ONLY),
    REFUSED(GL_INVALID_ENUM, UnmapBuffer, GL_TEXTURE_2D),
    REFUSED(GL_INVALID_OPERATION, UnmapBuffer, Array),
    REFUSED(GL_INVALID_ENUM, MapBufferRange, GL_TEXTURE_2D, 0, 4, GL_MAP_READ_BIT),
    REFUSED(GL_INVALID_ENUM, FlushMappedBufferRange, GL_TEXTURE_2D, 0, 4),
    REFUSED(GL_INVALID_OPERATION, FlushMappedBufferRange, Array, 0, 4),
    REFUSED(GL_INVALID_ENUM, CopyBufferSubData, GL_TEXTURE_2D, GL_COPY_WRITE_BUFFER, 0, 0, 4),
    REFUSED(GL_INVALID_OPERATION,
            CopyBufferSubData,
            GL_COPY_READ_BUFFER,
            GL_COPY_WRITE_BUFFER,
            0,
            0,
            4),
};

void bind_sixteen_bytes() {
    entry::BindBuffer(Array, 1);
    entry::BufferData(Array, 16, bytes, GL_STATIC_DRAW);
}

constexpr RefusedCall Bound[] = {
    REFUSED(GL_INVALID_ENUM, BufferData, Array, 4, bytes, GL_READ_ONLY),
    REFUSED(GL_INVALID_VALUE, BufferData, Array, -1, bytes, GL_STATIC_DRAW),
    REFUSED(GL_INVALID_VALUE, BufferSubData, Array, 13, 4, bytes),
    REFUSED(GL_INVALID_VALUE, BufferSubData, Array, -1, 4, bytes),
    REFUSED(GL_INVALID_VALUE, BufferSubData, Array, 0, -1, bytes),
    REFUSED(GL_INVALID_VALUE, GetBufferSubData, Array, 0, 17, bytes),
    REFUSED(GL_INVALID_ENUM, GetBufferParameteriv, Array, GL_BUFFER_MAP_POINTER, ints),
    REFUSED(GL_INVALID_ENUM, GetBufferPointerv, Array, GL_BUFFER_SIZE, pointers),
    REFUSED(GL_INVALID_ENUM, MapBuffer, Array, GL_STATIC_DRAW),
    REFUSED(GL_INVALID_OPERATION, UnmapBuffer, Array),
    REFUSED(GL_INVALID_VALUE, MapBufferRange, Array, 0, 17, GL_MAP_READ_BIT),
    REFUSED(GL_INVALID_VALUE, MapBufferRange, Array, 0, 4, GL_MAP_READ_BIT | 0x8000),
    REFUSED(GL_INVALID_OPERATION, MapBufferRange, Array, 0, 4, 0),
    REFUSED(GL_INVALID_OPERATION,
            MapBufferRange,
            Array,
            0,
            4,
            GL_MAP_READ_BIT | GL_MAP_INVALIDATE_BUFFER_BIT),
    REFUSED(GL_INVALID_OPERATION,
            MapBufferRange,
            Array,
            0,
            4,
            GL_MAP_READ_BIT | GL_MAP_FLUSH_EXPLICIT_BIT),
    REFUSED(GL_INVALID_OPERATION, FlushMappedBufferRange, Array, 0, 4),
    REFUSED(GL_INVALID_VALUE, CopyBufferSubData, Array, Array, 0, 4, 8),
    REFUSED(GL_INVALID_VALUE, CopyBufferSubData, Array, Array, 0, 8, 9),
};

void map_sixteen_bytes() {
    bind_sixteen_bytes();
    entry::MapBufferRange(Array, 4, 8, GL_MAP_WRITE_BIT | GL_MAP_FLUSH_EXPLICIT_BIT);
}

constexpr RefusedCall Mapped[] = {
    REFUSED(GL_INVALID_OPERATION, BufferSubData, Array, 0, 4, bytes),
    REFUSED(GL_INVALID_OPERATION, GetBufferSubData, Array, 0, 4, bytes),
    REFUSED(GL_INVALID_OPERATION, MapBuffer, Array, GL_READ_ONLY),
    REFUSED(GL_INVALID_OPERATION, MapBufferRange, Array, 0, 4, GL_MAP_READ_BIT),
    REFUSED(GL_INVALID_OPERATION, CopyBufferSubData, Array, Array, 0, 8, 4),
    REFUSED(GL_INVALID_VALUE, FlushMappedBufferRange, Array, 0, 9),
    REFUSED(GL_INVALID_VALUE, FlushMappedBufferRange, Array, -1, 1),
};

} // namespace

std::span<const Scene> buffer_scenes() {
    static const std::array all{
        Scene{"no buffer is bound", [] {}, Unbound},
        Scene{"a buffer of sixteen bytes", bind_sixteen_bytes, Bound},
        Scene{"eight of its bytes are mapped", map_sixteen_bytes, Mapped},
    };
    return all;
}

} // namespace ffgpu::gl::error_walk
