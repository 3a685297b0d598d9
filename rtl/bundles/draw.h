// What the fragment pipe is handed: a draw's registers, a primitive's planes and its record. The
// bundles of rtl/ffgpu_pipe_pkg.sv.

#pragma once

#include "model/raster/setup_record.h"
#include "rtl/bundles/fields.h"
#include "rtl/bundles/state.h"

namespace ffgpu::rtl {

// Attributes by number, as the record store keeps their planes.
constexpr unsigned InverseWAttribute = 0, FogAttribute = 1, PrimaryAttribute = 4,
                   SecondaryAttribute = 8, CoordinateAttributes = 16;

struct PlaneWrite {
    std::uint8_t attribute = 0;
    std::int32_t whole = 0;
    std::uint32_t fraction = 0;
    std::int64_t dx = 0, dy = 0;
    std::uint8_t scale = 0;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        field("attribute", self.attribute, 6);
        field("whole", self.whole, 32);
        field("fraction", self.fraction, 14);
        field("dx", self.dx, 45);
        field("dy", self.dy, 45);
        field("scale", self.scale, 8);
    }
};

// A record with its draw.
struct RecordWords {
    bool tag = false;
    std::uint32_t draw = 0;
    SetupRecord record;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        auto& record = self.record;
        field("tag", self.tag, 1);
        field("draw", self.draw, 32);
        field("primitive", record.key, 32);
        field("piece", record.piece, 32);
        field("front_facing", record.front_facing, 1);
        field("box_x0", record.box.x0, 14);
        field("box_y0", record.box.y0, 14);
        field("box_x1", record.box.x1, 14);
        field("box_y1", record.box.y1, 14);
        field("edge_count", record.edge_count, 3);
        for (unsigned i = MaxEdges; i-- > 0;)
            field("a", record.edges[i].a, 23);
        for (unsigned i = MaxEdges; i-- > 0;)
            field("b", record.edges[i].b, 23);
        for (unsigned i = MaxEdges; i-- > 0;)
            field("c", record.edges[i].c, 45);
        field("depth_origin", record.depth.origin, 64);
        field("depth_dx", record.depth.dx, 64);
        field("depth_dy", record.depth.dy, 64);
        field("depth_min", record.depth_min, 24);
        field("depth_max", record.depth_max, 24);
        visit_shading(record, field);
    }

private:
    template <class Record, class Visitor>
    static void visit_shading(Record& record, Visitor&& field) {
        field("x_reference", record.x_reference, 15);
        field("y_reference", record.y_reference, 15);
        field("perspective", record.perspective, 1);
        field("constant_color", record.constant_color, 1);
        field("constant_secondary", record.constant_secondary, 1);
        visit_lanes(field, "color", record.color, 8);
        for (unsigned channel = 3; channel-- > 0;)
            field("secondary", record.secondary[channel], 8);
        field("inverse_w_floor", record.inverse_w_floor, 32);
        field("divided_units", record.divided_units, 8);
    }
};

struct SurfaceWords {
    std::uint32_t address = 0, stride = 0;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        field("address", self.address, 32);
        field("stride", self.stride, 32);
    }
};

struct DrawWords {
    std::uint64_t carried = 0; // attributes, a bit each
    std::uint8_t sampled_units = 0;
    std::array<Combiner, TextureUnits> combiners;
    ControlWords control;
    FogWords fog;
    StencilDepthWords stencil_depth;
    BlendWords blend;
    SurfaceWords depth_place, color_place;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        field("carried", self.carried, 48);
        field("sampled_units", self.sampled_units, 8);
        for (unsigned unit = TextureUnits; unit-- > 0;)
            visit_register(field, "combiner", self.combiners[unit]);
        ControlWords::visit(self.control, field);
        FogWords::visit(self.fog, field);
        StencilDepthWords::visit(self.stencil_depth, field);
        BlendWords::visit(self.blend, field);
        SurfaceWords::visit(self.depth_place, field);
        SurfaceWords::visit(self.color_place, field);
    }
};

} // namespace ffgpu::rtl
