// ArrayGather: reads vertices out of the application's arrays, whatever their types and strides,
// and lays them side by side as the device fetches them.

#pragma once

#include "driver/state/vertex_array_state.h"
#include "driver/vertex/vertex_run.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace ffgpu::gl {

class ArrayGather {
public:
    // The enabled arrays of `object`; an array in a buffer that is mapped makes is_mapped() true.
    explicit ArrayGather(const VertexArrayObject& object);

    const VertexFormat& format() const { return format_; }
    bool has_positions() const { return format_.elements[0].components != 0; }
    bool is_mapped() const { return mapped_; }

    // Vertices first .. first + count - 1. `to` has format().stride words a vertex. Elements
    // beyond the end of a buffer object read as zero; memory of the application's own has no end
    // that we know of.
    void range(std::uint32_t first, std::uint32_t count, float* to) const;
    // The vertices that `indices` name, in their order.
    void indexed(std::span<const std::uint32_t> indices, float* to) const;

    // Reads `count` elements, `stride` bytes apart, to places `to_stride` words apart.
    using Convert = void (*)(const std::byte* from,
                             std::size_t stride,
                             std::size_t count,
                             float* to,
                             unsigned to_stride);

private:
    struct Source {
        const std::byte* first = nullptr;
        std::size_t stride = 0;
        std::uint64_t elements = 0; // that exist
        Convert convert = nullptr;
        std::uint8_t offset = 0, components = 0; // in the vertex, in words
    };

    void add(Attribute attribute, const VertexArray& array);

    VertexFormat format_ = EmptyVertexFormat;
    std::array<Source, Attributes> sources_{};
    bool mapped_ = false;
};

// Bytes of one number of a type of vertex arrays; 0: GL does not know the type.
unsigned array_type_bytes(GLenum type);

} // namespace ffgpu::gl
