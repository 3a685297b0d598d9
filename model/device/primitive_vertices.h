// How many vertices a primitive of each type takes.

#pragma once

#include "model/device/commands.h"

#include <cstdint>

namespace ffgpu {

// Primitives of such a type do not share vertices: two runs one after the other are one.
constexpr bool is_independent(PrimitiveType type) {
    return type == PrimitiveType::Points || type == PrimitiveType::Lines ||
           type == PrimitiveType::Triangles || type == PrimitiveType::Quads;
}

// Of one such primitive.
constexpr std::uint32_t vertices_of_one(PrimitiveType type) {
    switch (type) {
    case PrimitiveType::Points:
        return 1;
    case PrimitiveType::Lines:
    case PrimitiveType::LineLoop:
    case PrimitiveType::LineStrip:
        return 2;
    case PrimitiveType::Triangles:
    case PrimitiveType::TriangleStrip:
    case PrimitiveType::TriangleFan:
    case PrimitiveType::Polygon:
        return 3;
    case PrimitiveType::Quads:
    case PrimitiveType::QuadStrip:
        return 4;
    }
    return 1;
}

} // namespace ffgpu
