// The indices of glDrawElements, in the application's memory or in a buffer object.

#pragma once

#include "driver/gl_types.h"
#include "driver/objects/buffer_object.h"

#include <cstdint>
#include <cstring>
#include <vector>

namespace ffgpu::gl {

// Bytes of an index; 0: GL does not know the type.
constexpr unsigned index_bytes(GLenum type) {
    switch (type) {
    case GL_UNSIGNED_BYTE:
        return 1;
    case GL_UNSIGNED_SHORT:
        return 2;
    case GL_UNSIGNED_INT:
        return 4;
    default:
        return 0;
    }
}

class IndexReader {
public:
    // `indices`: an address, or with a buffer an offset into it.
    IndexReader(const void* indices, const BufferObject* buffer, GLenum type, std::size_t count)
        : type_(type)
        , count_(count) {
        if (buffer) {
            const auto offset = reinterpret_cast<std::size_t>(indices);
            const std::size_t bytes = count * index_bytes(type);
            const bool fits = offset <= buffer->size() && bytes <= buffer->size() - offset;
            from_ = fits ? buffer->bytes().data() + offset : nullptr;
        } else {
            from_ = static_cast<const std::byte*>(indices);
        }
    }

    // False: they go beyond the end of the buffer, or there are none.
    bool in_range() const { return from_ != nullptr; }

    void read(std::vector<std::uint32_t>& to) const {
        switch (type_) {
        case GL_UNSIGNED_BYTE:
            return read_as<GLubyte>(to);
        case GL_UNSIGNED_SHORT:
            return read_as<GLushort>(to);
        default:
            return read_as<GLuint>(to);
        }
    }

private:
    template <class Index>
    void read_as(std::vector<std::uint32_t>& to) const {
        to.resize(count_);
        for (std::size_t i = 0; i < count_; ++i) {
            Index index;
            std::memcpy(&index, from_ + i * sizeof(Index), sizeof(Index));
            to[i] = index;
        }
    }

    const std::byte* from_ = nullptr;
    GLenum type_;
    std::size_t count_;
};

} // namespace ffgpu::gl
