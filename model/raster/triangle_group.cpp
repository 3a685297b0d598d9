#include "model/raster/triangle_group.h"

#include "model/raster/plane_setup.h"

#include <algorithm>
#include <bit>

namespace ffgpu {

bool goes_in_groups(const SetupContext& context) {
    const PrimitiveSetup& primitive = context.primitive;
    return !context.multisample && !context.clip.empty() && !primitive.polygon_smooth &&
           !primitive.polygon_stipple && !primitive.offset_fill &&
           context.layout.count < MaxInterpolants;
}

void set_up_triangles_scalar(const SetupContext&,
                             std::span<const Primitive>,
                             TriangleGroup& group) {
    group.alone = 0xff;
}

void write_record(const SetupContext& context,
                  const TriangleGroup& group,
                  unsigned i,
                  const Primitive& triangle,
                  SetupRecord& record) {
    const unsigned place = 1u << i;
    const auto bit = [place](TriangleGroup::Bits bits) { return (bits & place) != 0; };
    record.box = group.box[i];
    for (unsigned edge = 0; edge < 3; ++edge)
        record.edges[edge] = group.edges[edge][i];
    record.edge_fractions = std::bit_cast<std::array<std::uint8_t, 4>>(group.edge_fractions[i]);
    record.edge_count = 3;
    record.coverage = CoverageKind::Centre;
    record.stipple = StippleKind::None;
    record.front_facing = triangle.front_facing;
    record.covers_nothing = false;
    record.perspective = bit(group.perspective);
    record.constant_color = bit(group.constant_color);
    record.constant_secondary = bit(group.constant_secondary);
    record.plane_count = context.layout.count;
    record.divided_units = divided_units(triangle.vertices, context.layout);
    record.color = std::bit_cast<std::array<std::uint8_t, 4>>(group.color[i]);
    record.secondary = std::bit_cast<std::array<std::uint8_t, 4>>(group.secondary[i]);
    record.key = triangle.key;
    record.x_reference = group.x_reference[i];
    record.y_reference = group.y_reference[i];
    record.depth = group.depth[i];
    record.depth_min = group.depth_min[i];
    record.depth_max = group.depth_max[i];
    record.inverse_w_floor = group.inverse_w_floor[i];
    StoredPlane* const planes = record.planes();
    const unsigned count = record.plane_count + unsigned{record.perspective};
    for (unsigned plane = 0; plane < count; ++plane)
        planes[plane] = group.planes[plane][i];
}

} // namespace ffgpu
