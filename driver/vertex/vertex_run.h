// VertexRun: vertices as the device reads them, and the primitives made of them.

#pragma once

#include "model/device/commands.h"
#include "model/device/registers/vertex.h"

#include <array>
#include <cstdint>
#include <span>

namespace ffgpu::gl {

struct RunPrimitive {
    PrimitiveType type = PrimitiveType::Points;
    bool continue_line_stipple = false;
    std::uint32_t first = 0;
    std::uint32_t count = 0;
};

// A view: the words belong to whoever made the run.
struct VertexRun {
    VertexFormat format;
    std::span<const float> words; // format.stride a vertex
    std::span<const RunPrimitive> primitives;

    std::uint32_t vertex_count() const {
        return format.stride == 0 ? 0 : static_cast<std::uint32_t>(words.size() / format.stride);
    }
};

// What an attribute's components are where they are not given.
constexpr std::array<float, 4> MissingComponents{0, 0, 0, 1};

// The same format with `attribute` at least `components` wide. Attributes stand in their order,
// position first, without gaps.
VertexFormat widen(const VertexFormat& format, Attribute attribute, unsigned components);

// One vertex from one format to a wider one. What is not in `from` gets MissingComponents.
void convert_vertex(const VertexFormat& from,
                    const VertexFormat& to,
                    const float* source,
                    float* destination);

constexpr VertexFormat EmptyVertexFormat{.stride = 0, .elements = {}};

constexpr std::size_t attribute_index(Attribute attribute) {
    return static_cast<std::size_t>(attribute);
}

} // namespace ffgpu::gl
