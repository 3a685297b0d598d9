// Buffer objects (GL 1.5, 2.9): bytes that the application put under a name. They are kept in host
// memory: vertices are gathered from there, pixels unpacked from and packed to it.

#pragma once

#include "driver/gl_types.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace ffgpu::gl {

class BufferObject {
public:
    explicit BufferObject(GLuint name)
        : name_(name) {}

    GLuint name() const { return name_; }
    std::span<std::byte> bytes() { return data_; }
    std::span<const std::byte> bytes() const { return data_; }
    std::size_t size() const { return data_.size(); }

    // `bytes` from `offset` on, as an address to read or write; null where they do not lie within
    // the buffer. (Adding to null, as an application's offset is given, is not defined in C++.)
    std::byte* at(std::size_t offset, std::size_t bytes) {
        return contains(offset, bytes) ? data_.data() + offset : nullptr;
    }
    bool contains(std::size_t offset, std::size_t bytes) const {
        return offset <= data_.size() && bytes <= data_.size() - offset;
    }

    // Throws std::bad_alloc; the old contents are then kept.
    void allocate(std::size_t size, const void* data) {
        std::vector<std::byte> fresh(size);
        if (data) std::copy_n(static_cast<const std::byte*>(data), size, fresh.data());
        data_ = std::move(fresh);
    }

    GLenum usage = GL_STATIC_DRAW;

    // The mapping that glMapBuffer or glMapBufferRange made; a mapped buffer is not used otherwise.
    bool mapped = false;
    GLbitfield map_access = 0; // GL_MAP_READ_BIT ...
    std::size_t map_offset = 0, map_length = 0;

    void unmap() {
        mapped = false;
        map_access = 0;
        map_offset = map_length = 0;
    }
    // An empty buffer has an address, too.
    std::byte* mapped_bytes() { return data_.empty() ? &nothing_ : data_.data() + map_offset; }

    // Of the last mapping: GL_READ_ONLY, GL_WRITE_ONLY or GL_READ_WRITE.
    GLenum access = GL_READ_WRITE;

private:
    GLuint name_;
    std::vector<std::byte> data_;
    std::byte nothing_{};
};

} // namespace ffgpu::gl
