// Texture coordinates from geometry (T10): where on an image does a point of a surface lie?
//
// All functions take a point of object space and yield (u, v), the image being [0, 1] x [0, 1];
// they are evaluated for each vertex and interpolated by the hardware, so that a mesh must be fine
// where a mapping is curved. Angles are in radians; z is the axis of cylinders and spheres. Source:
// Marschner and Shirley, Fundamentals of Computer Graphics, chapter 11; proxy objects: Bier and
// Sloan 1986, "Two-part texture mappings".

#pragma once

#include <array>
#include <optional>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace ffgpu::techniques {

// (u, v, *, 1) = matrix (x, y, z, 1). The matrix is affine: an image laid on by parallel rays.
glm::dvec2 planar_orthographic(const glm::dmat4& matrix, const glm::dvec3& point);

// (u, v) = (u~/w, v~/w), (u~, v~, *, w) = matrix (x, y, z, 1): as a slide projector throws it.
// Nothing for w <= 0: the point lies beside or behind the projector.
std::optional<glm::dvec2> planar_perspective(const glm::dmat4& matrix, const glm::dvec3& point);

// u = (phi + pi) / 2 pi, phi = atan2(y, x) in (-pi, pi]; v runs from 0 at `low` to 1 at `high`.
struct Cylinder {
    glm::dvec3 centre{0}; // Its z is of no account.
    double low = -1, high = 1;
};
glm::dvec2 cylindrical(const Cylinder& cylinder, const glm::dvec3& point);

// u as above; v = theta / pi, theta = acos((z - zc) / r): 0 at the upper pole, 1 at the lower one.
// r is the point's own distance from the centre; the centre itself maps to (1/2, 1/2).
glm::dvec2 spherical(const glm::dvec3& centre, const glm::dvec3& point);

// The surface normal instead of the place: where the normal would touch the unit sphere.
glm::dvec2 normal_on_sphere(const glm::dvec3& normal);

// The six sides of the box that a surface is wrapped in.
enum class BoxFace { PositiveX, NegativeX, PositiveY, NegativeY, PositiveZ, NegativeZ };

// The side that the direction meets; of equal components the first of x, y, z counts.
BoxFace box_face(const glm::dvec3& direction);
// The point seen straight on that side of a box from -half_size to half_size. Seen from outside, u
// runs right; v runs along z on the upright sides and along y on those of z.
glm::dvec2 box(BoxFace face, const glm::dvec3& half_size, const glm::dvec3& point);

// u of a triangle's corners so that it does not run around the seam: values more than half a turn
// below the largest get 1 more. The texture then has to repeat.
std::array<double, 3> across_seam(std::array<double, 3> u);

// Two steps: the image lies on a proxy, and the target's points are carried to the proxy.
enum class Proxy { Cylinder, Sphere, Box };
enum class ProxyWay {
    ProxyNormal,  // the point of the proxy whose normal passes through the target's point
    TargetNormal, // where the target's normal meets the proxy
    CentreRay     // where the ray from the target's centre (the origin) meets the proxy
};
struct ProxyObject {
    Proxy shape = Proxy::Sphere;
    double radius = 2; // of sphere and cylinder; half the edge of the box; the cylinder is 2 high
                       // upwards and downwards for each unit of its radius
};
// The target lies inside of the proxy. A cylinder has no lids: it goes on with v outside of [0, 1].
glm::dvec2
by_proxy(const ProxyObject& proxy, ProxyWay way, const glm::dvec3& point, const glm::dvec3& normal);

} // namespace ffgpu::techniques
