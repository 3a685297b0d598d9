#include "driver/vertex/array_gather.h"

#include "driver/objects/buffer_object.h"
#include "driver/vertex/component.h"
#include "model/base/check.h"

#include <algorithm>
#include <cstring>

namespace ffgpu::gl {

namespace {

template <class Number, unsigned N, bool Normalized>
void convert(
    const std::byte* from, std::size_t stride, std::size_t count, float* to, unsigned to_stride) {
    for (std::size_t i = 0; i < count; ++i, from += stride, to += to_stride) {
        std::array<Number, N> numbers;
        std::memcpy(numbers.data(), from, sizeof(numbers)); // It may lie at any address.
        for (unsigned c = 0; c < N; ++c)
            to[c] = Normalized ? normalized(numbers[c]) : plain(numbers[c]);
    }
}

void convert_bgra(
    const std::byte* from, std::size_t stride, std::size_t count, float* to, unsigned to_stride) {
    for (std::size_t i = 0; i < count; ++i, from += stride, to += to_stride) {
        std::array<GLubyte, 4> bgra;
        std::memcpy(bgra.data(), from, sizeof(bgra));
        to[0] = normalized(bgra[2]);
        to[1] = normalized(bgra[1]);
        to[2] = normalized(bgra[0]);
        to[3] = normalized(bgra[3]);
    }
}

void convert_flag(
    const std::byte* from, std::size_t stride, std::size_t count, float* to, unsigned to_stride) {
    for (std::size_t i = 0; i < count; ++i, from += stride, to += to_stride)
        *to = *from == std::byte{0} ? 0.0f : 1.0f;
}

template <class Number>
ArrayGather::Convert convert_of(GLint size, bool is_normalized) {
    switch (size) {
    case 1:
        return is_normalized ? convert<Number, 1, true> : convert<Number, 1, false>;
    case 2:
        return is_normalized ? convert<Number, 2, true> : convert<Number, 2, false>;
    case 3:
        return is_normalized ? convert<Number, 3, true> : convert<Number, 3, false>;
    default:
        return is_normalized ? convert<Number, 4, true> : convert<Number, 4, false>;
    }
}

ArrayGather::Convert convert_of(const VertexArray& array) {
    switch (array.type) {
    case GL_BYTE:
        return convert_of<GLbyte>(array.size, array.normalized);
    case GL_UNSIGNED_BYTE:
        return array.bgra ? convert_bgra : convert_of<GLubyte>(array.size, array.normalized);
    case GL_SHORT:
        return convert_of<GLshort>(array.size, array.normalized);
    case GL_UNSIGNED_SHORT:
        return convert_of<GLushort>(array.size, array.normalized);
    case GL_INT:
        return convert_of<GLint>(array.size, array.normalized);
    case GL_UNSIGNED_INT:
        return convert_of<GLuint>(array.size, array.normalized);
    case GL_DOUBLE:
        return convert_of<GLdouble>(array.size, array.normalized);
    default:
        return convert_of<GLfloat>(array.size, array.normalized);
    }
}

} // namespace

unsigned array_type_bytes(GLenum type) {
    switch (type) {
    case GL_BYTE:
    case GL_UNSIGNED_BYTE:
        return 1;
    case GL_SHORT:
    case GL_UNSIGNED_SHORT:
        return 2;
    case GL_INT:
    case GL_UNSIGNED_INT:
    case GL_FLOAT:
        return 4;
    case GL_DOUBLE:
        return 8;
    default:
        return 0;
    }
}

ArrayGather::ArrayGather(const VertexArrayObject& object) {
    for (std::size_t a = 0; a < Attributes; ++a) {
        if (object.arrays[a].enabled) add(static_cast<Attribute>(a), object.arrays[a]);
    }
}

void ArrayGather::add(Attribute attribute, const VertexArray& array) {
    VertexElement& element = format_.elements[attribute_index(attribute)];
    element = {.components = static_cast<std::uint8_t>(array.size), .offset = format_.stride};
    format_.stride = static_cast<std::uint8_t>(format_.stride + array.size);
    const std::size_t bytes = array_type_bytes(array.type) * static_cast<std::size_t>(array.size);
    Source source{.first = static_cast<const std::byte*>(array.pointer),
                  .stride = array.stride != 0 ? static_cast<std::size_t>(array.stride) : bytes,
                  .elements = ~std::uint64_t{0},
                  .convert = attribute == Attribute::EdgeFlag ? convert_flag : convert_of(array),
                  .offset = element.offset,
                  .components = element.components};
    check(source.stride != 0, "an array of a type without a size");
    if (array.buffer) {
        mapped_ = mapped_ || array.buffer->mapped;
        const auto offset = reinterpret_cast<std::size_t>(array.pointer);
        const std::size_t size = array.buffer->size();
        const bool any = offset <= size && bytes <= size - offset;
        source.elements = any ? (size - offset - bytes) / source.stride + 1 : 0;
        source.first = any ? array.buffer->bytes().data() + offset : nullptr;
    } else if (!array.pointer) {
        source.elements = 0; // An array that was enabled, but never given.
    }
    sources_[attribute_index(attribute)] = source;
}

void ArrayGather::range(std::uint32_t first, std::uint32_t count, float* to) const {
    const unsigned stride = format_.stride;
    for (const Source& source : sources_) {
        if (source.components == 0) continue;
        const std::uint64_t existing = source.elements > first ? source.elements - first : 0;
        const auto read = static_cast<std::size_t>(std::min<std::uint64_t>(existing, count));
        float* const place = to + source.offset;
        if (read != 0)
            source.convert(
                source.first + first * source.stride, source.stride, read, place, stride);
        for (std::size_t i = read; i < count; ++i)
            std::fill_n(place + i * stride, source.components, 0.0f);
    }
}

void ArrayGather::indexed(std::span<const std::uint32_t> indices, float* to) const {
    const unsigned stride = format_.stride;
    for (const Source& source : sources_) {
        if (source.components == 0) continue;
        float* place = to + source.offset;
        for (const std::uint32_t i : indices) {
            if (i < source.elements) {
                source.convert(source.first + i * source.stride, 0, 1, place, stride);
            } else {
                std::fill_n(place, source.components, 0.0f);
            }
            place += stride;
        }
    }
}

} // namespace ffgpu::gl
