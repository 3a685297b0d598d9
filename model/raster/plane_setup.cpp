#include "model/raster/plane_setup.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace ffgpu {
namespace {

constexpr double SubPixels = 1 << SubPixelBits;
constexpr double DepthOne = std::int64_t{1} << DepthPlane::FractionBits;

// A step beyond 16 times the full depth range from pixel to pixel is cut off: then no two centres
// lie inside, and depth_min and depth_max bound the one.
constexpr double MaxDepthStep = static_cast<double>(std::int64_t{1} << 52);

// To nearest, halves away from zero; NaN is 0.
std::int64_t round_clamped(double value, double limit) {
    if (!(value > -limit)) return value <= -limit ? static_cast<std::int64_t>(-limit) : 0;
    return static_cast<std::int64_t>(std::min(value, limit) + (value < 0 ? -0.5 : 0.5));
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
    const auto e1 = static_cast<double>(z[1] - z[0]);
    const auto e2 = static_cast<double>(z[2] - z[0]);
    return {e1 * basis.x1 + e2 * basis.x2, e1 * basis.y1 + e2 * basis.y2};
}

std::array<std::int64_t, 3> vertex_depths(const SetupContext& context, const PlaneVertices& v) {
    return {plane_depth(context, v[0]->depth),
            plane_depth(context, v[1]->depth),
            plane_depth(context, v[2]->depth)};
}

// From vertex 0 to the centre of the reference pixel, in 1/256 pixel.
struct ReferenceOffset {
    std::int32_t x, y;
};

ReferenceOffset reference_offset(const WindowVertex& vertex, const SetupRecord& record) {
    constexpr int Half = 1 << (SubPixelBits - 1);
    return {(record.x_reference << SubPixelBits) + Half - vertex.x,
            (record.y_reference << SubPixelBits) + Half - vertex.y};
}

void set_up_depth(const SetupContext& context,
                  const PlaneVertices& vertices,
                  const PlaneBasis& basis,
                  SetupRecord& record) {
    const std::array<std::int64_t, 3> z = vertex_depths(context, vertices);
    const DepthSteps steps = depth_steps(z, basis);
    DepthPlane& plane = record.depth;
    plane.dx = round_clamped(steps.dx, MaxDepthStep);
    plane.dy = round_clamped(steps.dy, MaxDepthStep);
    const ReferenceOffset offset = reference_offset(*vertices[0], record);
    plane.origin =
        z[0] +
        ((plane.dx * offset.x + plane.dy * offset.y + (1 << (SubPixelBits - 1))) >> SubPixelBits);
    const auto [lowest, highest] = std::minmax({z[0], z[1], z[2]});
    record.depth_min = round_depth(context, lowest);
    record.depth_max = round_depth(context, highest);
}

// The power of two that brings `value`, positive and finite, into [1, 2).
float scale_to_one(float value) {
    const std::uint32_t exponent = std::bit_cast<std::uint32_t>(value) >> 23;
    return std::bit_cast<float>((254 - std::clamp<std::uint32_t>(exponent, 1, 253)) << 23);
}

// The binary32 form of the basis, and of the way to the reference pixel in pixels.
struct FloatBasis {
    float x1, x2, y1, y2;
    float x, y;

    AttributePlane plane(float v0, float v1, float v2) const {
        const float e1 = v1 - v0, e2 = v2 - v0;
        const float dx = e1 * x1 + e2 * x2;
        const float dy = e1 * y1 + e2 * y2;
        return {v0 + (dx * x + dy * y), dx, dy};
    }
};

void set_up_attributes(const PlaneVertices& v,
                       const std::array<float, 3>& weights,
                       const FloatBasis& basis,
                       SetupRecord& record) {
    const unsigned count = record.plane_count;
    float* const c = record.plane_c();
    float* const dx = record.plane_dx();
    float* const dy = record.plane_dy();
    for (unsigned i = 0; i < count; ++i) {
        // A weight of 1 is exact: one loop serves planes with and without perspective.
        const AttributePlane plane = basis.plane(v[0]->attributes[i] * weights[0],
                                                 v[1]->attributes[i] * weights[1],
                                                 v[2]->attributes[i] * weights[2]);
        c[i] = plane.c;
        dx[i] = plane.dx;
        dy[i] = plane.dy;
    }
}

// Where all vertices carry the same bits from `first` on, the planes' c become those values.
bool set_up_constant(const PlaneVertices& v, int first, std::size_t count, SetupRecord& record) {
    if (first < 0) return false;
    const float* const value = v[0]->attributes.data() + first;
    const std::size_t bytes = count * sizeof(float);
    if (std::memcmp(value, v[1]->attributes.data() + first, bytes) != 0 ||
        std::memcmp(value, v[2]->attributes.data() + first, bytes) != 0)
        return false;
    std::copy_n(value, count, record.plane_c() + first);
    return true;
}

} // namespace

PlaneBasis triangle_basis(const PlaneVertices& v) {
    const std::int32_t dx1 = v[1]->x - v[0]->x, dy1 = v[1]->y - v[0]->y;
    const std::int32_t dx2 = v[2]->x - v[0]->x, dy2 = v[2]->y - v[0]->y;
    const std::int64_t area = std::int64_t{dx1} * dy2 - std::int64_t{dx2} * dy1;
    if (area == 0) return {};
    const double scale = SubPixels / static_cast<double>(area);
    return {dy2 * scale, -dy1 * scale, -dx2 * scale, dx1 * scale};
}

PlaneBasis line_basis(const WindowVertex& from, const WindowVertex& to) {
    const std::int64_t dx = to.x - from.x, dy = to.y - from.y;
    const std::int64_t square = dx * dx + dy * dy;
    if (square == 0) return {};
    const double scale = SubPixels / static_cast<double>(square);
    return {.x1 = static_cast<double>(dx) * scale, .y1 = static_cast<double>(dy) * scale};
}

void set_up_planes(const SetupContext& context,
                   const PlaneVertices& v,
                   const PlaneBasis& basis,
                   SetupRecord& record) {
    record.x_reference = v[0]->x >> SubPixelBits;
    record.y_reference = v[0]->y >> SubPixelBits;
    set_up_depth(context, v, basis, record);

    const ReferenceOffset offset = reference_offset(*v[0], record);
    const FloatBasis float_basis{static_cast<float>(basis.x1),
                                 static_cast<float>(basis.x2),
                                 static_cast<float>(basis.y1),
                                 static_cast<float>(basis.y2),
                                 static_cast<float>(offset.x) / static_cast<float>(SubPixels),
                                 static_cast<float>(offset.y) / static_cast<float>(SubPixels)};
    std::array<float, 3> weights{1, 1, 1};
    record.perspective = v[0]->inverse_w != v[1]->inverse_w || v[0]->inverse_w != v[2]->inverse_w;
    if (record.perspective) {
        const auto [lowest, highest] =
            std::minmax({v[0]->inverse_w, v[1]->inverse_w, v[2]->inverse_w});
        const float scale = scale_to_one(highest);
        for (unsigned i = 0; i < 3; ++i)
            weights[i] = v[i]->inverse_w * scale;
        record.inverse_w = float_basis.plane(weights[0], weights[1], weights[2]);
        record.inverse_w_floor = lowest * scale * 0.5f;
    }
    record.plane_count = context.layout.count;
    set_up_attributes(v, weights, float_basis, record);
    record.constant_color = set_up_constant(v, context.layout.color, 4, record);
    record.constant_secondary = set_up_constant(v, context.layout.secondary, 3, record);
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
