#include "model/raster/plane_setup.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <cstring>

namespace ffgpu {
namespace {

constexpr double DepthOne = std::int64_t{1} << DepthPlane::FractionBits;

// A step beyond 16 times the full depth range from pixel to pixel is cut off: then no two centres
// next to each other along that axis lie inside, and depth_min and depth_max bound those that do.
constexpr double MaxDepthStep = static_cast<double>(std::int64_t{1} << 52);

// To nearest, halves away from zero; NaN is 0.
std::int64_t round_clamped(double value, double limit) {
    if (value != value) return 0;
    return static_cast<std::int64_t>(std::clamp(value, -limit, limit) + std::copysign(0.5, value));
}

// Window depth in [0, 1] to the plane's units. The product is exact before it is rounded.
std::int64_t plane_depth(const SetupContext& context, float depth) {
    const float clamped = depth > 0 ? std::min(depth, 1.0f) : 0.0f;
    const double scaled = static_cast<double>(clamped) * (DepthOne * context.depth_scale);
    return static_cast<std::int64_t>(scaled + 0.5);
}

std::uint32_t round_depth(const SetupContext& context, std::int64_t plane) {
    const std::int64_t half = std::int64_t{1} << (DepthPlane::FractionBits - 1);
    const std::int64_t rounded = (plane + half) >> DepthPlane::FractionBits;
    return static_cast<std::uint32_t>(
        std::clamp<std::int64_t>(rounded, 0, std::int64_t{context.depth_scale}));
}

struct DepthSteps {
    double dx, dy;
};

DepthSteps depth_steps(const std::array<std::int64_t, 3>& z, const PlaneBasis& basis) {
    const double scale = basis.per_divisor;
    const auto e1 = static_cast<double>(z[1] - z[0]);
    const auto e2 = static_cast<double>(z[2] - z[0]);
    return {e1 * (basis.x1 * scale) + e2 * (basis.x2 * scale),
            e1 * (basis.y1 * scale) + e2 * (basis.y2 * scale)};
}

inline std::array<std::int64_t, 3> vertex_depths(const SetupContext& context,
                                                 const PlaneVertices& v) {
    return {plane_depth(context, v[0]->depth),
            plane_depth(context, v[1]->depth),
            plane_depth(context, v[2]->depth)};
}

// The reference pixel is the one that holds the vertex.
ReferenceOffset reference_offset(const WindowVertex& vertex) {
    constexpr int One = 1 << SubPixelBits, Half = One / 2;
    return {Half - (vertex.x & (One - 1)), Half - (vertex.y & (One - 1))};
}

void set_up_depth(const SetupContext& context, const PlaneGeometry& geometry, SetupRecord& record) {
    const ReferenceOffset& offset = geometry.attributes.offset;
    const std::array<std::int64_t, 3> z = vertex_depths(context, geometry.vertices);
    const DepthSteps steps = depth_steps(z, geometry.depth());
    DepthPlane& plane = record.depth;
    plane.dx = round_clamped(steps.dx, MaxDepthStep);
    plane.dy = round_clamped(steps.dy, MaxDepthStep);
    plane.origin =
        z[0] +
        ((plane.dx * offset.x + plane.dy * offset.y + (1 << (SubPixelBits - 1))) >> SubPixelBits);
    record.depth_min = round_depth(context, std::min(std::min(z[0], z[1]), z[2]));
    record.depth_max = round_depth(context, std::max(std::max(z[0], z[1]), z[2]));
}

// The power of two that brings `value`, positive and finite, into [1, 2).
double scale_to_one(float value) {
    const auto exponent = static_cast<std::uint64_t>(std::bit_cast<std::uint32_t>(value) >> 23);
    return std::bit_cast<double>((1023 + 127 - exponent) << 52);
}

// All planes, and that of k, which stands behind them.
void set_up_attribute_planes(const SetupContext& context,
                             const PlaneGeometry& geometry,
                             SetupRecord& record) {
    const AttributeFrame& frame = geometry.attributes;
    const PlaneVertices& v = geometry.vertices;
    AttributeValues values{
        .of = {v[0]->attributes.data(), v[1]->attributes.data(), v[2]->attributes.data()},
        .layout = context.layout,
        .perspective = v[0]->inverse_w != v[1]->inverse_w || v[0]->inverse_w != v[2]->inverse_w};
    record.perspective = values.perspective;
    record.plane_count = context.layout.count;
    if (!record.perspective) {
        set_up_attributes(values, frame, record.planes());
        return;
    }
    const float lowest = std::min(std::min(v[0]->inverse_w, v[1]->inverse_w), v[2]->inverse_w);
    const float highest = std::max(std::max(v[0]->inverse_w, v[1]->inverse_w), v[2]->inverse_w);
    const double to_one = scale_to_one(highest);
    for (unsigned j = 0; j < 3; ++j)
        values.k[j] = static_cast<double>(v[j]->inverse_w) * to_one;
    const int base_exponent = set_up_attributes(values, frame, record.planes());
    const double half =
        static_cast<double>(lowest) * to_one * (1 << (ValueBits - 1 - base_exponent));
    record.inverse_w_floor = std::max(1, static_cast<std::int32_t>(half));
}

// Where all vertices carry the same colour, `color` becomes it.
template <std::size_t Channels>
bool set_up_constant(const PlaneVertices& v, int first, std::array<std::uint8_t, 4>& color) {
    if (first < 0) return false;
    const float* const value = v[0]->attributes.data() + first;
    constexpr std::size_t Bytes = Channels * sizeof(float);
    // NOLINTBEGIN(bugprone-suspicious-memory-comparison): the same bits give the same colour.
    if (std::memcmp(value, v[1]->attributes.data() + first, Bytes) != 0 ||
        std::memcmp(value, v[2]->attributes.data() + first, Bytes) != 0)
        return false;
    // NOLINTEND(bugprone-suspicious-memory-comparison)
    for (std::size_t i = 0; i < Channels; ++i)
        color[i] = color_byte(value[i]);
    return true;
}

std::int32_t longest_axis(const WindowVertex& a, const WindowVertex& b) {
    return std::max(std::abs(b.x - a.x), std::abs(b.y - a.y));
}

// The cyclic order that puts the longest edge first.
PlaneVertices longest_edge_first(const PlaneVertices& v) {
    const std::int32_t a = longest_axis(*v[0], *v[1]), b = longest_axis(*v[1], *v[2]),
                       c = longest_axis(*v[2], *v[0]);
    if (a >= b && a >= c) return v;
    return b >= c ? PlaneVertices{v[1], v[2], v[0]} : PlaneVertices{v[2], v[0], v[1]};
}

constexpr double One = 1 << SubPixelBits;

// Two sides of a triangle, from its first vertex: integers of 23 bits, so that products are exact.
struct TriangleSides {
    double dx1, dy1, dx2, dy2, area;

    explicit TriangleSides(const PlaneVertices& v)
        : dx1(v[1]->x - v[0]->x)
        , dy1(v[1]->y - v[0]->y)
        , dx2(v[2]->x - v[0]->x)
        , dy2(v[2]->y - v[0]->y)
        , area(dx1 * dy2 - dx2 * dy1) {}

    PlaneBasis basis() const {
        if (area == 0) return {};
        const double sign = std::copysign(1.0, area), divisor = std::fabs(area);
        return {sign * dy2, -sign * dy1, -sign * dx2, sign * dx1, divisor, One / divisor};
    }
    // Less than 1/256 pixel high over its longest edge.
    bool are_sliver() const {
        const auto longest = [](double a, double b) {
            return std::max(std::max(std::fabs(a), std::fabs(b)), std::fabs(b - a));
        };
        return std::fabs(area) < std::max(longest(dx1, dx2), longest(dy1, dy2));
    }
};

} // namespace

std::uint8_t divided_units(const PlaneVertices& v, const InterpolantLayout& layout) {
    // No byte of it has more bits than 4 = with q.
    const auto components = std::bit_cast<std::uint64_t>(layout.tex_components);
    if ((components & 0x0404040404040404) == 0) return 0;
    unsigned units = 0;
    for (unsigned unit = 0; unit < TextureUnits; ++unit) {
        if (layout.tex_coord[unit] < 0 || layout.tex_components[unit] < 4) continue;
        const auto q = static_cast<unsigned>(layout.tex_coord[unit] + 3);
        const bool divides =
            v[0]->attributes[q] != 1 || v[1]->attributes[q] != 1 || v[2]->attributes[q] != 1;
        units |= static_cast<unsigned>(divides) << unit;
    }
    return static_cast<std::uint8_t>(units);
}

std::uint8_t color_byte(float color) {
    const float positive = color > 0 ? color : 0; // NaN is 0.
    return static_cast<std::uint8_t>(std::min(positive, 1.0f) * 255.0f + 0.5f);
}

PlaneBasis triangle_basis(const PlaneVertices& vertices) {
    return TriangleSides(vertices).basis();
}

PlaneBasis line_basis(const WindowVertex& from, const WindowVertex& to) {
    const double dx = to.x - from.x, dy = to.y - from.y;
    const double square = dx * dx + dy * dy;
    if (square == 0) return {};
    return {.x1 = dx, .y1 = dy, .divisor = square, .per_divisor = One / square};
}

PlaneGeometry triangle_geometry(const PlaneVertices& vertices) {
    const TriangleSides sides(vertices);
    if (!sides.are_sliver()) [[likely]]
        return {vertices, {sides.basis(), reference_offset(*vertices[0])}};
    const PlaneVertices longest = longest_edge_first(vertices);
    const WindowVertex& from = *longest[0];
    return {longest, {line_basis(from, *longest[1]), reference_offset(from)}, true};
}

PlaneGeometry line_geometry(const WindowVertex& from, const WindowVertex& to, float width) {
    return {{&from, &to, &from},
            {line_basis(from, to), reference_offset(from), static_cast<int>(width * 0.5f) + 3}};
}

PlaneGeometry point_geometry(const WindowVertex& vertex) {
    return {{&vertex, &vertex, &vertex}, {{}, reference_offset(vertex)}};
}

void set_up_triangle_planes(const SetupContext& context,
                            const PlaneVertices& vertices,
                            SetupRecord& record) {
    set_up_planes(context, triangle_geometry(vertices), record);
}

void set_up_planes(const SetupContext& context,
                   const PlaneGeometry& geometry,
                   SetupRecord& record) {
    const PlaneVertices& v = geometry.vertices;
    record.x_reference = v[0]->x >> SubPixelBits;
    record.y_reference = v[0]->y >> SubPixelBits;
    set_up_depth(context, geometry, record);
    set_up_attribute_planes(context, geometry, record);
    record.constant_color = set_up_constant<4>(v, context.layout.color, record.color);
    record.constant_secondary = set_up_constant<3>(v, context.layout.secondary, record.secondary);
    record.divided_units = divided_units(v, context.layout);
}

void add_depth_offset(const SetupContext& context,
                      const PlaneVertices& slope_vertices,
                      const PlaneBasis& basis,
                      SetupRecord& record) {
    const DepthSteps steps = depth_steps(vertex_depths(context, slope_vertices), basis);
    const auto magnitude = [](double step) { return step < 0 ? -step : step; };
    const double slope = std::max(magnitude(steps.dx), magnitude(steps.dy));
    const PrimitiveSetup& setup = context.primitive;
    const double offset = slope * static_cast<double>(setup.offset_factor) +
                          DepthOne * static_cast<double>(setup.offset_units);
    const std::int64_t shift = round_clamped(offset, DepthOne * (1 << 25));
    record.depth.origin += shift;
    const auto moved = [&](std::uint32_t depth) {
        return round_depth(context, (std::int64_t{depth} << DepthPlane::FractionBits) + shift);
    };
    record.depth_min = moved(record.depth_min);
    record.depth_max = moved(record.depth_max);
}

} // namespace ffgpu
