// Procedural textures (T21): colour as a function of the place, in two and three dimensions.
//
// Source: Perlin 1985, "An Image Synthesizer"; Ebert et al., Texturing and Modeling.

#pragma once

#include "techniques/image.h"

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace ffgpu::techniques {

// Fourier-like synthesis: d(x, y) = sum over i of c_i cos(a_i x + b_i y + phase_i), the frequencies
// (a_i, b_i), in radians a unit of length, in the annulus inner <= |(a, b)| <= outer.
struct Wave {
    glm::dvec2 frequency;
    double amplitude, phase;
};
// `count` waves of amplitude 1/count, so that |d| <= 1. For each, draws of Random(seed) in this
// order: squared radius (uniform by area), direction, phase.
std::vector<Wave> annulus_waves(std::uint64_t seed, int count, double inner, double outer);
double fourier(const std::vector<Wave>& waves, const glm::dvec2& point);

// Perlin's gradient noise, of the lattice of integers, 0 at each of its points, in (-1, 1):
//   n(p) = sum over the 8 lattice points q around p of w(dx) w(dy) w(dz) (gradient(q) . (p - q)),
//   w(t) = 2 |t|^3 - 3 t^2 + 1, |t| < 1.
class GradientNoise {
public:
    // period > 0: the lattice repeats after so many units along each axis; 0: it does not.
    explicit GradientNoise(std::uint64_t seed, int period = 0)
        : seed_(seed)
        , period_(period) {}

    double operator()(const glm::dvec3& point) const;

    // A unit vector. h = mix(mix(mix(seed + 1 + x) + y) + z), mix() of Random, the coordinates
    // taken modulo 2^64; its high and low 32 bits over 2^32 are z = 2 a - 1 and the turn around z.
    glm::dvec3 gradient(int x, int y, int z) const;

    static double weight(double t);

private:
    std::uint64_t seed_;
    int period_;
};

// sum over i < octaves of |n(2^i p)| / 2^i: in [0, 2).
double turbulence(const GradientNoise& noise, const glm::dvec3& point, int octaves);

// 3-D stripes: (1 + sin(2 pi (direction . p) / width + swing turbulence(p))) / 2 in [0, 1]; with no
// swing plain stripes, with some the marble of 1985.
struct Stripes {
    glm::dvec3 direction{1, 0, 0}; // a unit vector
    double width = 1;              // from a stripe to the next
    double swing = 0;              // radians for each unit of turbulence
    int octaves = 4;
};
double stripe(const Stripes& stripes, const GradientNoise& noise, const glm::dvec3& point);

} // namespace ffgpu::techniques
