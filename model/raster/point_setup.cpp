// Points: squares of whole pixels, circles by area, sprites; in multisampled targets circles and
// sprites by samples (GL 1.5, 3.3.3).

#include "model/raster/plane_setup.h"
#include "model/raster/sample_positions.h"
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

// GL 1.5, 3.3: where multisampling is on, a point below the fade threshold is drawn in its size
// and fades instead.
struct PointSize {
    float size, fade;
};

PointSize faded_size(const SetupContext& context, float size) {
    const float threshold = context.primitive.point_fade_threshold;
    if (!context.multisample || !(size < threshold)) return {size, 1};
    return {clamped_size(threshold), (size / threshold) * (size / threshold)};
}

void fade_alpha(const SetupContext& context, float fade, SetupRecord& record) {
    if (fade == 1 || context.layout.color < 0) return;
    float& alpha = record.plane_c()[context.layout.color + 3];
    alpha = (alpha > 0 ? std::min(alpha, 1.0f) : 0.0f) * fade;
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

// The square that a sprite's samples lie in.
void set_up_sampled_square(const WindowVertex& vertex, std::int32_t half, SetupRecord& record) {
    const std::int32_t left = vertex.x - half, right = vertex.x + half;
    const std::int32_t bottom = vertex.y - half, top = vertex.y + half;
    const std::array<SubPixelPoint, 4> corners{
        {{left, bottom}, {right, bottom}, {right, top}, {left, top}}};
    for (unsigned i = 0; i < 4; ++i)
        record.set_edge(i, make_exact_edge(corners[i], corners[(i + 1) % 4]));
    record.edge_count = 4;
    record.coverage = CoverageKind::Samples;
    record.box = sampled_pixels(corners[0], corners[2]);
}

// Corners 0 and 1.x of the record, for smooth and multisampled circles.
void set_up_circle(const WindowVertex& vertex, std::int32_t half, SetupRecord& record) {
    record.corners[0] = {vertex.x, vertex.y};
    record.corners[1] = {half, 0};
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
    const auto [size, fade] = faded_size(context, clamped_size(vertex.point_size));
    const std::int32_t half = half_size(size);
    record.edge_count = 0;
    if (context.multisample && context.primitive.point_sprite) {
        set_up_sampled_square(vertex, half, record);
    } else if (context.multisample) {
        // What lies on the circle is inside.
        record.box = sampled_pixels({vertex.x - half, vertex.y - half},
                                    {vertex.x + half + 1, vertex.y + half + 1});
        record.coverage = CoverageKind::SamplePoint;
        set_up_circle(vertex, half, record);
    } else if (context.primitive.point_sprite) {
        record.box = sprite_square(vertex, half);
    } else if (context.primitive.point_smooth) {
        // The circle's edge is soft over one pixel: half a pixel more than its radius.
        record.box = touched_square(vertex, half + Half);
        record.coverage = CoverageKind::SmoothPoint;
        set_up_circle(vertex, half, record);
    } else {
        record.box = square(vertex, size);
    }
    record.box = intersect(record.box, context.clip);
    if (record.box.empty()) return false;

    const PlaneVertices all{&vertex, &vertex, &vertex};
    set_up_planes(context, all, {}, record);
    fade_alpha(context, fade, record);
    if (context.primitive.point_sprite) set_up_sprite(context, vertex, size, record);
    if (primitive.from_polygon && context.primitive.offset_point) {
        const bool has_slope = primitive.vertices[1] && primitive.vertices[2];
        const PlaneVertices& plane = has_slope ? primitive.vertices : all;
        add_depth_offset(context, plane, triangle_basis(plane), record);
    }
    return true;
}

} // namespace ffgpu
