// Panels, rays and look-ups, as the oracles see them.

#pragma once

#include "tests/gallery/harness/images.h"
#include "tests/gallery/oracles/oracle.h"

#include <array>
#include <optional>

#include <glm/common.hpp>

namespace ffgpu::gallery {

// Where in which panel: `unit` is [0, 1]^2 of the panel, `pixel` counts pixels from its corner.
struct Place {
    int panel;
    glm::dvec2 unit, pixel, size;
};
Place place_in(const glm::dvec2& window, int columns, int rows);

// A pinhole: what gluLookAt and gluPerspective mean, in real numbers.
struct Eye {
    glm::dvec3 position, forward, right, up; // an orthonormal frame
    double tangent, aspect;                  // of half the vertical field of view; width to height

    Eye(const glm::dvec3& from, const glm::dvec3& to, const glm::dvec3& upwards, glm::dvec2 field);
    // Towards a point of the picture, [0, 1]^2; the component along `forward` is 1.
    glm::dvec3 ray(const glm::dvec2& unit) const;
    // The components along right, up and forward.
    glm::dvec3 in_frame(const glm::dvec3& direction) const;
    // Where a point is seen, [0, 1]^2; it lies in front.
    glm::dvec2 seen_at(const glm::dvec3& point) const;
};

// The smallest distance > 0 along the ray, in lengths of `direction`.
std::optional<double>
hit_ellipsoid(const glm::dvec3& from, const glm::dvec3& direction, const glm::dvec3& radii);
// The first meeting with a cube around the origin, and the axis of the side that is met.
struct BoxHit {
    double distance;
    int axis;
};
std::optional<BoxHit> hit_cube(const glm::dvec3& from, const glm::dvec3& direction, double half);

// Colours of an image, in [0, 1]; texel indices repeat.
Color texel(const Image& image, int x, int y);
Color nearest(const Image& image, const glm::dvec2& uv);
Color bilinear(const Image& image, const glm::dvec2& uv);
Color bilinear_clamped(const Image& image, const glm::dvec2& uv); // to the edge
Color bilinear_bordered(const Image& image, const glm::dvec2& uv, const Color& border);

// Two-dimensional triangle: the weights of the corners, by areas.
glm::dvec3 barycentric(const std::array<glm::dvec2, 3>& corners, const glm::dvec2& point);

inline Color clamped(const Color& color) {
    return glm::min(glm::max(color, Color(0)), Color(1));
}

} // namespace ffgpu::gallery
