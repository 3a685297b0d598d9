// Points: squares of whole pixels, circles by area, sprites.

#include "model/raster/plane_setup.h"
#include "model/raster/shape_setup.h"

#include <algorithm>

namespace ffgpu {
namespace {

constexpr std::int32_t One = 1 << SubPixelBits;
constexpr std::int32_t Half = One / 2;
constexpr float MaxPointSize = 1024;

float clamped_size(float size) {
    return size > 0 ? std::min(size, MaxPointSize) : 1.0f;
}

// Half a size in pixels, in 1/256 pixel, to nearest.
std::int32_t half_size(float size) {
    return std::max(1, static_cast<std::int32_t>(size * static_cast<float>(Half) + 0.5f));
}

// GL 1.5, 3.3: an odd size is centred on the pixel of the point, an even one on the pixel corner
// nearest to it.
Rectangle square(const WindowVertex& vertex, float size) {
    const int width = std::max(1, static_cast<int>(size + 0.5f));
    const std::int32_t shift = width % 2 == 1 ? 0 : Half;
    const int x = ((vertex.x + shift) >> SubPixelBits) - width / 2;
    const int y = ((vertex.y + shift) >> SubPixelBits) - width / 2;
    return {x, y, x + width, y + width};
}

// Pixels whose centres lie in the square of the given half size around the point.
Rectangle sprite_square(const WindowVertex& vertex, std::int32_t half) {
    const auto first_centre = [](std::int32_t at) { return (at + Half - 1) >> SubPixelBits; };
    return {first_centre(vertex.x - half),
            first_centre(vertex.y - half),
            first_centre(vertex.x + half),
            first_centre(vertex.y + half)};
}

Rectangle touched_square(const WindowVertex& vertex, std::int32_t half) {
    return {(vertex.x - half) >> SubPixelBits,
            (vertex.y - half) >> SubPixelBits,
            (vertex.x + half + One - 1) >> SubPixelBits,
            (vertex.y + half + One - 1) >> SubPixelBits};
}

// s = 1/2 + (X + 1/2 - x) / size, t = 1/2 -+ (Y + 1/2 - y) / size, r = 0, q = 1.
void set_up_sprite(const SetupContext& context,
                   const WindowVertex& vertex,
                   float size,
                   SetupRecord& record) {
    const float step = 1.0f / size;
    const float t_step = context.primitive.point_sprite_origin_lower_left ? step : -step;
    const auto offset = [](int reference, std::int32_t at) {
        return static_cast<float>((reference << SubPixelBits) + Half - at) /
               static_cast<float>(One);
    };
    const AttributePlane s{0.5f + offset(record.x_reference, vertex.x) * step, step, 0};
    const AttributePlane t{0.5f + offset(record.y_reference, vertex.y) * t_step, 0, t_step};
    const std::array<AttributePlane, 4> planes{s, t, {0, 0, 0}, {1, 0, 0}};
    for (unsigned unit = 0; unit < TextureUnits; ++unit) {
        const int first = context.layout.tex_coord[unit];
        if (first < 0 || !((context.primitive.point_sprite_replace >> unit) & 1)) continue;
        for (unsigned i = 0; i < context.layout.tex_components[unit]; ++i) {
            record.plane_c()[first + static_cast<int>(i)] = planes[i].c;
            record.plane_dx()[first + static_cast<int>(i)] = planes[i].dx;
            record.plane_dy()[first + static_cast<int>(i)] = planes[i].dy;
        }
    }
}

} // namespace

bool set_up_point(const SetupContext& context, const Primitive& primitive, SetupRecord& record) {
    const WindowVertex& vertex = *primitive.vertices[0];
    const float size = clamped_size(vertex.point_size);
    const std::int32_t half = half_size(size);
    record.edge_count = 0;
    if (context.primitive.point_sprite) {
        record.box = sprite_square(vertex, half);
    } else if (context.primitive.point_smooth) {
        // The circle's edge is soft over one pixel: half a pixel more than its radius.
        record.box = touched_square(vertex, half + Half);
        record.coverage = CoverageKind::SmoothPoint;
        record.corners[0] = {vertex.x, vertex.y};
        record.corners[1] = {half, 0};
    } else {
        record.box = square(vertex, size);
    }
    record.box = intersect(record.box, context.clip);
    if (record.box.empty()) return false;

    const PlaneVertices all{&vertex, &vertex, &vertex};
    set_up_planes(context, all, {}, record);
    if (context.primitive.point_sprite) set_up_sprite(context, vertex, size, record);
    if (primitive.from_polygon && context.primitive.offset_point) {
        const bool has_slope = primitive.vertices[1] && primitive.vertices[2];
        const PlaneVertices& plane = has_slope ? primitive.vertices : all;
        add_depth_offset(context, plane, triangle_basis(plane), record);
    }
    return true;
}

} // namespace ffgpu
