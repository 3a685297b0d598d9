#include "techniques/mapping.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace ffgpu::techniques {
namespace {

constexpr double Pi = std::numbers::pi;

double turn(double y, double x) {
    return (std::atan2(y, x) + Pi) / (2 * Pi);
}

// The larger root of |origin + t direction|^2 = radius^2, of the first `dimensions` axes.
double
leave_round(const glm::dvec3& origin, const glm::dvec3& direction, double radius, int dimensions) {
    double a = 0, b = 0, c = -radius * radius;
    for (int axis = 0; axis < dimensions; ++axis) {
        a += direction[axis] * direction[axis];
        b += origin[axis] * direction[axis];
        c += origin[axis] * origin[axis];
    }
    if (a <= 0) return 0; // Along the axis of a cylinder: the point keeps its place.
    return (-b + std::sqrt(std::max(0.0, b * b - a * c))) / a;
}

double leave_box(const glm::dvec3& origin, const glm::dvec3& direction, double half) {
    double nearest = HUGE_VAL;
    for (int axis = 0; axis < 3; ++axis) {
        if (direction[axis] == 0) continue;
        const double side = direction[axis] > 0 ? half : -half;
        nearest = std::min(nearest, (side - origin[axis]) / direction[axis]);
    }
    return std::isfinite(nearest) ? nearest : 0;
}

glm::dvec3 meet(const ProxyObject& proxy, const glm::dvec3& origin, const glm::dvec3& direction) {
    switch (proxy.shape) {
    case Proxy::Cylinder:
        return origin + leave_round(origin, direction, proxy.radius, 2) * direction;
    case Proxy::Sphere:
        return origin + leave_round(origin, direction, proxy.radius, 3) * direction;
    case Proxy::Box:
        return origin + leave_box(origin, direction, proxy.radius) * direction;
    }
    return origin;
}

glm::dvec2 on_proxy(const ProxyObject& proxy, const glm::dvec3& place) {
    switch (proxy.shape) {
    case Proxy::Cylinder:
        return cylindrical({glm::dvec3(0), -2 * proxy.radius, 2 * proxy.radius}, place);
    case Proxy::Sphere:
        return spherical(glm::dvec3(0), place);
    case Proxy::Box:
        return box(box_face(place), glm::dvec3(proxy.radius), place);
    }
    return {};
}

// The direction in which the proxy's normal passes through the point.
glm::dvec3 proxy_normal_at(Proxy shape, const glm::dvec3& point) {
    if (shape == Proxy::Cylinder) return {point.x, point.y, 0};
    if (shape == Proxy::Sphere) return point;
    const int axis = static_cast<int>(box_face(point)) / 2;
    glm::dvec3 normal(0);
    normal[axis] = point[axis];
    return normal;
}

} // namespace

glm::dvec2 planar_orthographic(const glm::dmat4& matrix, const glm::dvec3& point) {
    return glm::dvec2(matrix * glm::dvec4(point, 1));
}

std::optional<glm::dvec2> planar_perspective(const glm::dmat4& matrix, const glm::dvec3& point) {
    const glm::dvec4 projected = matrix * glm::dvec4(point, 1);
    if (!(projected.w > 0)) return std::nullopt;
    return glm::dvec2(projected) / projected.w;
}

glm::dvec2 cylindrical(const Cylinder& cylinder, const glm::dvec3& point) {
    const glm::dvec3 offset = point - cylinder.centre;
    return {turn(offset.y, offset.x), (point.z - cylinder.low) / (cylinder.high - cylinder.low)};
}

glm::dvec2 spherical(const glm::dvec3& centre, const glm::dvec3& point) {
    const glm::dvec3 offset = point - centre;
    const double radius = glm::length(offset);
    if (radius <= 0) return {0.5, 0.5};
    const double theta = std::acos(std::clamp(offset.z / radius, -1.0, 1.0));
    return {turn(offset.y, offset.x), theta / Pi};
}

glm::dvec2 normal_on_sphere(const glm::dvec3& normal) {
    return spherical(glm::dvec3(0), normal);
}

BoxFace box_face(const glm::dvec3& direction) {
    const glm::dvec3 size = glm::abs(direction);
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    return static_cast<BoxFace>(2 * axis + (direction[axis] < 0 ? 1 : 0));
}

glm::dvec2 box(BoxFace face, const glm::dvec3& half_size, const glm::dvec3& point) {
    const glm::dvec3 unit = (point / half_size + 1.0) * 0.5;
    switch (face) {
    case BoxFace::PositiveX:
        return {unit.y, unit.z};
    case BoxFace::NegativeX:
        return {1 - unit.y, unit.z};
    case BoxFace::PositiveY:
        return {1 - unit.x, unit.z};
    case BoxFace::NegativeY:
        return {unit.x, unit.z};
    case BoxFace::PositiveZ:
        return {unit.x, unit.y};
    case BoxFace::NegativeZ:
        return {1 - unit.x, unit.y};
    }
    return {};
}

std::array<double, 3> across_seam(std::array<double, 3> u) {
    const double largest = std::max({u[0], u[1], u[2]});
    for (double& corner : u) {
        if (largest - corner > 0.5) corner += 1;
    }
    return u;
}

glm::dvec2 by_proxy(const ProxyObject& proxy,
                    ProxyWay way,
                    const glm::dvec3& point,
                    const glm::dvec3& normal) {
    switch (way) {
    case ProxyWay::ProxyNormal:
        return on_proxy(proxy, meet(proxy, point, proxy_normal_at(proxy.shape, point)));
    case ProxyWay::TargetNormal:
        return on_proxy(proxy, meet(proxy, point, normal));
    case ProxyWay::CentreRay:
        return on_proxy(proxy, meet(proxy, glm::dvec3(0), point));
    }
    return {};
}

} // namespace ffgpu::techniques
