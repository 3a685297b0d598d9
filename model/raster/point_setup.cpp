// Points: squares of whole pixels, circles by area, sprites; in multisampled targets circles and
// sprites by samples (GL 1.5, 3.3.3).

#include "model/raster/plane_setup.h"
#include "model/raster/sample_positions.h"
#include "model/raster/shape_setup.h"

#include <algorithm>
#include <cmath>

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

void fade_alpha(const SetupContext& context,
                const WindowVertex& vertex,
                float fade,
                SetupRecord& record) {
    if (fade == 1 || context.layout.color < 0) return;
    const float alpha = vertex.attributes[static_cast<unsigned>(context.layout.color) + 3];
    record.color[3] = color_byte((alpha > 0 ? std::min(alpha, 1.0f) : 0.0f) * fade);
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

// A sprite's coordinate along one axis: 1/2 `offset` pixels from the point, and `step` a pixel.
struct SpriteAxis {
    double offset, step;
    bool along_x;
};

AttributePlane sprite_plane(const SpriteAxis& axis) {
    // Lanes of touched quads lie up to two pixels outside.
    int exponent = 1;
    for (double reached = 1 + 2 * std::abs(axis.step); reached >= 4; reached *= 0.5)
        ++exponent;
    const double one =
        static_cast<double>(std::int64_t{1} << (ValueBits + AttributePlane::GuardBits)) /
        static_cast<double>(1 << exponent);
    const auto step = static_cast<std::int64_t>(std::floor(axis.step * one + 0.5));
    const double c = (0.5 + axis.offset * axis.step) * one;
    return {static_cast<std::int64_t>(std::floor(c + 0.5)),
            axis.along_x ? step : 0,
            axis.along_x ? 0 : step,
            static_cast<float>(1 << exponent) / static_cast<float>(1 << ValueBits)};
}

AttributePlane constant_plane(int value) {
    constexpr int Bits = ValueBits - 1;
    return {value * (std::int64_t{1} << (Bits + AttributePlane::GuardBits)),
            0,
            0,
            1.0f / static_cast<float>(1 << Bits)};
}

// s = 1/2 + (X + 1/2 - x) / size, t = 1/2 -+ (Y + 1/2 - y) / size, r = 0, q = 1.
void set_up_sprite(const SetupContext& context,
                   const WindowVertex& vertex,
                   float size,
                   SetupRecord& record) {
    const double step = 1 / std::max(static_cast<double>(size), 1.0 / (One / 2));
    const double t_step = context.primitive.point_sprite_origin_lower_left ? step : -step;
    const auto offset = [](int reference, std::int32_t at) {
        return static_cast<double>((reference << SubPixelBits) + Half - at) / One;
    };
    const std::array<AttributePlane, 4> planes{
        sprite_plane({offset(record.x_reference, vertex.x), step, true}),
        sprite_plane({offset(record.y_reference, vertex.y), t_step, false}),
        constant_plane(0),
        constant_plane(1)};
    for (unsigned unit = 0; unit < TextureUnits; ++unit) {
        const int first = context.layout.tex_coord[unit];
        if (first < 0 || !((context.primitive.point_sprite_replace >> unit) & 1)) continue;
        record.divided_units &= static_cast<std::uint8_t>(~(1u << unit));
        for (unsigned i = 0; i < context.layout.tex_components[unit]; ++i)
            record.planes()[static_cast<unsigned>(first) + i] = StoredPlane(planes[i]);
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
    set_up_planes(context, point_geometry(vertex), record);
    fade_alpha(context, vertex, fade, record);
    if (context.primitive.point_sprite) set_up_sprite(context, vertex, size, record);
    if (primitive.from_polygon && context.primitive.offset_point) {
        const bool has_slope = primitive.vertices[1] && primitive.vertices[2];
        const PlaneVertices& plane = has_slope ? primitive.vertices : all;
        add_depth_offset(context, plane, triangle_basis(plane), record);
    }
    return true;
}

} // namespace ffgpu
