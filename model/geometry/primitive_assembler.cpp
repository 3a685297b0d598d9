#include "model/geometry/primitive_assembler.h"

namespace ffgpu {

ChunkRule chunk_rule(PrimitiveType type) {
    switch (type) {
    case PrimitiveType::LineStrip:
        return {.overlap = 1};
    case PrimitiveType::LineLoop:
        return {.hub = true, .overlap = 1};
    case PrimitiveType::TriangleStrip:
        return {.overlap = 2};
    case PrimitiveType::QuadStrip:
        return {.overlap = 2};
    case PrimitiveType::TriangleFan:
        return {.hub = true, .overlap = 1};
    case PrimitiveType::Polygon:
        return {.hub = true, .overlap = 1};
    default:
        return {};
    }
}

namespace {

// The key of the chunk's first primitive. A polygon is one primitive, whatever its chunks.
std::uint32_t first_key(PrimitiveType type, const ElementChunk& chunk) {
    switch (type) {
    case PrimitiveType::Lines:
    case PrimitiveType::QuadStrip:
        return chunk.first / 2;
    case PrimitiveType::Triangles:
        return chunk.first / 3;
    case PrimitiveType::Quads:
        return chunk.first / 4;
    case PrimitiveType::TriangleFan:
        return chunk.first - 1;
    case PrimitiveType::LineLoop:
        return chunk.is_first ? 0 : chunk.first;
    case PrimitiveType::Polygon:
        return 0;
    default:
        return chunk.first;
    }
}

} // namespace

void PrimitiveAssembler::start(const DrawCommand& command) {
    type_ = command.primitive;
    if (!command.continue_line_stipple) stage_.reset_line_stipple();
}

void PrimitiveAssembler::assemble(const ElementChunk& chunk) {
    first_ = chunk.first - (chunk_rule(type_).hub ? 1 : 0);
    key_ = first_key(type_, chunk);
    switch (type_) {
    case PrimitiveType::Points:
        return points(chunk.slots);
    case PrimitiveType::Lines:
        return lines(chunk.slots);
    case PrimitiveType::LineStrip:
        return line_strip(chunk.slots, 0);
    case PrimitiveType::LineLoop:
        return line_loop(chunk);
    case PrimitiveType::Triangles:
        return triangles(chunk.slots);
    case PrimitiveType::TriangleStrip:
        return triangle_strip(chunk.slots);
    case PrimitiveType::TriangleFan:
        return triangle_fan(chunk.slots);
    case PrimitiveType::Quads:
        return quads(chunk.slots);
    case PrimitiveType::QuadStrip:
        return quad_strip(chunk.slots);
    case PrimitiveType::Polygon:
        return polygon(chunk);
    }
}

void PrimitiveAssembler::points(Slots slots) {
    for (std::size_t i = 0; i < slots.size(); ++i) {
        next_key(i);
        stage_.point(slots[i]);
    }
}

void PrimitiveAssembler::lines(Slots slots) {
    for (std::size_t i = 0; i + 1 < slots.size(); i += 2) {
        next_key(i + 1);
        stage_.reset_line_stipple();
        stage_.line(slots[i], slots[i + 1]);
    }
}

void PrimitiveAssembler::line_strip(Slots slots, std::size_t from) {
    for (std::size_t i = from; i + 1 < slots.size(); ++i) {
        next_key(i + 1);
        stage_.line(slots[i], slots[i + 1]);
    }
}

// The line from the hub to its successor belongs to the first chunk, the one back to it to the
// last.
void PrimitiveAssembler::line_loop(const ElementChunk& chunk) {
    const Slots slots = chunk.slots;
    line_strip(slots, chunk.is_first ? 0 : 1);
    if (!chunk.is_last || slots.size() < 2) return;
    next_key(slots.size() - 1);
    stage_.line(slots.back(), slots.front());
}

void PrimitiveAssembler::triangles(Slots slots) {
    for (std::size_t i = 0; i + 2 < slots.size(); i += 3)
        triangle({slots[i], slots[i + 1], slots[i + 2]}, i + 2, true);
}

// Every other triangle is turned over, so that all face the same way. Chunks begin at even
// elements.
void PrimitiveAssembler::triangle_strip(Slots slots) {
    for (std::size_t i = 0; i + 2 < slots.size(); ++i) {
        const std::size_t odd = i % 2;
        triangle({slots[i + odd], slots[i + 1 - odd], slots[i + 2]}, i + 2, false);
    }
}

void PrimitiveAssembler::triangle_fan(Slots slots) {
    for (std::size_t i = 1; i + 1 < slots.size(); ++i)
        triangle({slots[0], slots[i], slots[i + 1]}, i + 1, false);
}

void PrimitiveAssembler::quads(Slots slots) {
    for (std::size_t i = 0; i + 3 < slots.size(); i += 4)
        quad({slots[i], slots[i + 1], slots[i + 2], slots[i + 3]}, i + 3, true);
}

void PrimitiveAssembler::quad_strip(Slots slots) {
    for (std::size_t i = 0; i + 3 < slots.size(); i += 2)
        quad({slots[i + 2], slots[i], slots[i + 1], slots[i + 3]}, i + 3, false);
}

// A polygon of several chunks is cut along lines from its hub, which are no boundaries.
void PrimitiveAssembler::polygon(const ElementChunk& chunk) {
    const Slots slots = chunk.slots;
    if (slots.size() < 3) return;
    if (!stage_.whole_polygons()) {
        for (std::size_t i = 1; i + 1 < slots.size(); ++i) {
            begin(key_, i + 1);
            stage_.triangle({slots[0], slots[i], slots[i + 1]}, slots[0]);
        }
        return;
    }
    begin(key_, slots.size() - 1);
    corners_.clear();
    for (const std::uint32_t slot : slots)
        corners_.push_back({slot, pool_.edge_flag(slot)});
    if (!chunk.is_first) corners_.front().boundary = false;
    if (!chunk.is_last) corners_.back().boundary = false;
    stage_.polygon(corners_, slots[0]);
}

void PrimitiveAssembler::triangle(const std::array<std::uint32_t, 3>& slots,
                                  std::size_t last,
                                  bool uses_edge_flags) {
    next_key(last);
    if (!stage_.whole_polygons()) return stage_.triangle(slots, slots[2]);
    std::array<PolygonCorner, 3> corners;
    for (unsigned i = 0; i < 3; ++i)
        corners[i] = {slots[i], !uses_edge_flags || pool_.edge_flag(slots[i])};
    stage_.polygon(corners, slots[2]);
}

// Split from the second to the last corner, the provoking one, which both triangles then have.
void PrimitiveAssembler::quad(std::array<std::uint32_t, 4> slots,
                              std::size_t last,
                              bool uses_edge_flags) {
    next_key(last);
    if (!stage_.whole_polygons()) {
        stage_.triangle({slots[0], slots[1], slots[3]}, slots[3]);
        stage_.triangle({slots[1], slots[2], slots[3]}, slots[3]);
        return;
    }
    std::array<PolygonCorner, 4> corners;
    for (unsigned i = 0; i < 4; ++i)
        corners[i] = {slots[i], !uses_edge_flags || pool_.edge_flag(slots[i])};
    stage_.polygon(corners, slots[3]);
}

} // namespace ffgpu
