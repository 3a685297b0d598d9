// What the tile walker takes and gives.

#pragma once

#include "rtl/bundles/fields.h"

#include <array>
#include <cstdint>

namespace ffgpu::rtl {

constexpr int TileSize = 32;
constexpr unsigned TileEdgeCount = 4;

struct TileEdges {
    bool tag = false;
    std::uint32_t draw = 0, primitive = 0, piece = 0;
    bool front_facing = false;
    std::uint16_t tile_x = 0, tile_y = 0;
    std::uint16_t box_x0 = 0, box_y0 = 0, box_x1 = 0, box_y1 = 0;
    std::uint8_t edge_count = 0;
    std::array<std::int32_t, TileEdgeCount> a{}, b{};
    std::array<std::int64_t, TileEdgeCount> c{};

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        field("tag", self.tag, 1);
        field("key.draw", self.draw, 32);
        field("key.primitive_number", self.primitive, 32);
        field("key.piece", self.piece, 32);
        field("front_facing", self.front_facing, 1);
        field("tile_x", self.tile_x, 13);
        field("tile_y", self.tile_y, 13);
        field("box_x0", self.box_x0, 14);
        field("box_y0", self.box_y0, 14);
        field("box_x1", self.box_x1, 14);
        field("box_y1", self.box_y1, 14);
        field("edge_count", self.edge_count, 3);
        visit_lanes(field, "a", self.a, 23);
        visit_lanes(field, "b", self.b, 23);
        visit_lanes(field, "c", self.c, 45);
    }
};

struct CoveredQuad {
    bool tag = false;
    std::uint32_t draw = 0, primitive = 0, piece = 0;
    bool front_facing = false;
    std::uint16_t x = 0, y = 0;
    std::uint8_t live = 0;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        field("tag", self.tag, 1);
        field("key.draw", self.draw, 32);
        field("key.primitive_number", self.primitive, 32);
        field("key.piece", self.piece, 32);
        field("front_facing", self.front_facing, 1);
        field("x", self.x, 13);
        field("y", self.y, 13);
        field("live", self.live, 4);
    }
};

} // namespace ffgpu::rtl
