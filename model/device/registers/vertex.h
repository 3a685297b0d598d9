// Registers of vertex fetch.

#pragma once

#include "model/device/layout/limits.h"

#include <array>
#include <cstdint>

namespace ffgpu {

// The attributes of a vertex, in the order in which they stand in CurrentAttributes.
enum class Attribute : std::uint8_t {
    Position,
    Normal,
    Color,
    SecondaryColor,
    FogCoordinate,
    EdgeFlag, // 0.0 or 1.0
    TexCoord0,
    Count = TexCoord0 + TextureUnits
};
constexpr unsigned Attributes = static_cast<unsigned>(Attribute::Count);

constexpr Attribute tex_coord(unsigned unit) {
    return static_cast<Attribute>(static_cast<unsigned>(Attribute::TexCoord0) + unit);
}

// One attribute in an interleaved vertex. Elements are binary32; missing ones are 0, 0, 0, 1.
struct VertexElement {
    std::uint8_t components = 0; // 0: not in the vertex, taken from CurrentAttributes; else 1 to 4
    std::uint8_t offset = 0;     // in words from the vertex's first

    bool operator==(const VertexElement&) const = default;
};

struct VertexFormat {
    static constexpr const char* Name = "vertex_format";

    std::uint8_t stride = 4; // words from a vertex to the next
    std::array<VertexElement, Attributes> elements{
        {{4, 0}}}; // Position in four words, nothing else.

    template <class Self, class Visitor>
    static constexpr void visit(Self& self, Visitor&& field) {
        field("stride", self.stride, 8);
        for (auto& element : self.elements) {
            field("components", element.components, 3);
            field("offset", element.offset, 8);
        }
    }
    bool operator==(const VertexFormat&) const = default;
};

// Values of the attributes that the vertices do not carry.
struct CurrentAttributes {
    static constexpr const char* Name = "current_attributes";

    std::array<std::array<float, 4>, Attributes> values{{
        {0, 0, 0, 1},
        {0, 0, 1, 1},
        {1, 1, 1, 1},
        {0, 0, 0, 1},
        {0, 0, 0, 1},
        {1, 0, 0, 1},
        {0, 0, 0, 1},
        {0, 0, 0, 1},
        {0, 0, 0, 1},
        {0, 0, 0, 1},
        {0, 0, 0, 1},
        {0, 0, 0, 1},
        {0, 0, 0, 1},
        {0, 0, 0, 1},
    }};

    template <class Self, class Visitor>
    static constexpr void visit(Self& self, Visitor&& field) {
        for (auto& value : self.values)
            for (auto& component : value)
                field("value", component);
    }
    bool operator==(const CurrentAttributes&) const = default;
};

} // namespace ffgpu
