// Vertex fetch: elements of a draw to vertex numbers, vertices in memory to planes.

#pragma once

#include "model/device/commands.h"
#include "model/geometry/vertex_batch.h"
#include "model/geometry/vertex_setup.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace ffgpu {

// The elements of a draw: which vertex the i-th one is.
class ElementReader {
public:
    // Empty if the draw reaches beyond memory, or has no vertices.
    ElementReader(std::span<const std::byte> memory,
                  const DrawCommand& command,
                  const VertexFormat& format);

    bool in_memory() const { return in_memory_; }
    bool indexed() const { return command_.index_type != IndexType::None; }

    // Numbers of the elements from `first` on. One beyond the last vertex is the last.
    void read(std::uint32_t first, std::span<std::uint32_t> numbers) const;

private:
    template <class Index>
    void read_indices(std::uint32_t first, std::span<std::uint32_t> numbers) const;

    DrawCommand command_;
    const std::byte* indices_ = nullptr;
    bool in_memory_ = false;
};

// Fills the planes of the attributes that the set-up reads.
class VertexFetch {
public:
    // Attributes that the vertices do not carry, and missing components, are written to the
    // batch's planes here, once for all batches.
    void start(const VertexSetup& setup, VertexBatch& batch);

    // `vertices`: the first vertex in memory.
    void fetch(const std::byte* vertices,
               std::span<const std::uint32_t> numbers,
               VertexBatch& batch) const;

private:
    struct Source {
        std::uint8_t attribute;
        std::uint8_t components;
        std::uint32_t offset; // bytes
    };

    std::array<Source, Attributes> sources_{};
    unsigned count_ = 0;
    std::size_t stride_ = 0; // bytes
};

} // namespace ffgpu
