// Primitive assembly: which vertices of a draw make which primitive, in which order, and which one
// lends its colours to flat shading (GL 1.5, 2.6.1 and table 2.12).

#pragma once

#include "model/device/commands.h"
#include "model/geometry/primitive_stage.h"

#include <cstdint>
#include <span>
#include <vector>

namespace ffgpu {

// How a primitive type's elements are cut into chunks that can be assembled one by one.
struct ChunkRule {
    bool hub = false;          // Element 0 belongs to each chunk.
    std::uint32_t overlap = 0; // Elements at the end of a chunk that begin the next.
};

ChunkRule chunk_rule(PrimitiveType type);

// A chunk: the elements' places in the vertex pool, the hub (if the rule has one) in front.
struct ElementChunk {
    std::span<const std::uint32_t> slots;
    std::uint32_t first = 0; // place in the draw of the first slot behind the hub
    bool is_first = true, is_last = true;
};

class PrimitiveAssembler {
public:
    PrimitiveAssembler(const VertexPool& pool, PrimitiveStage& stage)
        : pool_(pool)
        , stage_(stage) {}

    void start(const DrawCommand& command);
    // Those whose primitives count on from each other (line stipple) come in order.
    void assemble(const ElementChunk& chunk);

private:
    using Slots = std::span<const std::uint32_t>;

    // The primitive whose last vertex is slot `last` of the chunk; next_key() counts the key.
    void begin(std::uint32_t key, std::size_t last) {
        stage_.begin(key, static_cast<std::uint32_t>(first_ + last));
    }
    void next_key(std::size_t last) { begin(key_++, last); }
    void points(Slots slots);
    void lines(Slots slots);
    void line_strip(Slots slots, std::size_t from);
    void line_loop(const ElementChunk& chunk);
    void triangles(Slots slots);
    void triangle_strip(Slots slots);
    void triangle_fan(Slots slots);
    void quads(Slots slots);
    void quad_strip(Slots slots);
    void polygon(const ElementChunk& chunk);

    void
    triangle(const std::array<std::uint32_t, 3>& slots, std::size_t last, bool uses_edge_flags);
    void quad(std::array<std::uint32_t, 4> slots, std::size_t last, bool uses_edge_flags);

    const VertexPool& pool_;
    PrimitiveStage& stage_;
    PrimitiveType type_ = PrimitiveType::Points;
    std::uint32_t key_ = 0;
    std::uint32_t first_ = 0; // place in the draw of slot 0, were it no hub
    std::vector<PolygonCorner> corners_;
};

} // namespace ffgpu
