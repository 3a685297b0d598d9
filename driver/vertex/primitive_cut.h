// How a primitive that is drawn in pieces is cut: what can be drawn of its first n vertices, and
// which of them the next piece begins with. Order, facing and provoking vertices stay as they were.

#pragma once

#include "model/device/primitive_vertices.h"

#include <cstdint>

namespace ffgpu::gl {

// Of n vertices, those that make whole primitives: the rest is ignored at glEnd.
constexpr std::uint32_t whole_vertices(PrimitiveType type, std::uint32_t n) {
    const auto at_least = [n](std::uint32_t minimum) { return n < minimum ? 0 : n; };
    switch (type) {
    case PrimitiveType::Points:
        return n;
    case PrimitiveType::Lines:
        return n - n % 2;
    case PrimitiveType::LineLoop:
    case PrimitiveType::LineStrip:
        return at_least(2);
    case PrimitiveType::Triangles:
        return n - n % 3;
    case PrimitiveType::TriangleStrip:
    case PrimitiveType::TriangleFan:
    case PrimitiveType::Polygon:
        return at_least(3);
    case PrimitiveType::Quads:
        return n - n % 4;
    case PrimitiveType::QuadStrip:
        return n < 4 ? 0 : n - n % 2;
    }
    return 0;
}

struct PrimitiveCut {
    std::uint32_t drawn = 0;    // vertices of the piece
    std::uint32_t carried = 0;  // last vertices that the next piece repeats
    bool carries_first = false; // and before them the first one
};

constexpr PrimitiveCut cut_primitive(PrimitiveType type, std::uint32_t n) {
    const std::uint32_t whole = whole_vertices(type, n);
    switch (type) {
    case PrimitiveType::Points:
    case PrimitiveType::Lines:
    case PrimitiveType::Triangles:
    case PrimitiveType::Quads:
        return {whole, n - whole};
    case PrimitiveType::LineLoop:
    case PrimitiveType::LineStrip:
        return whole == 0 ? PrimitiveCut{0, n} : PrimitiveCut{n, 1};
    case PrimitiveType::TriangleFan:
    case PrimitiveType::Polygon:
        return whole == 0 ? PrimitiveCut{0, n} : PrimitiveCut{n, 1, true};
    case PrimitiveType::TriangleStrip:
    case PrimitiveType::QuadStrip:
        // An even number of vertices, so that the next piece begins with the same facing.
        if (n < 4) return {0, n};
        return n % 2 == 0 ? PrimitiveCut{n, 2} : PrimitiveCut{n - 1, 3};
    }
    return {};
}

} // namespace ffgpu::gl
