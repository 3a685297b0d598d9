// Noise as the documentation of the library words it, written a second time.

#pragma once

#include <cstdint>

#include <glm/vec3.hpp>

namespace ffgpu::gallery {

// Draws of SplitMix64 from a seed.
class Draws {
public:
    explicit Draws(std::uint64_t seed)
        : counter_(seed) {}
    std::uint64_t next();
    double unit(); // the upper 53 bits, over 2^53

private:
    std::uint64_t counter_;
};

double gradient_noise(std::uint64_t seed, const glm::dvec3& point);
double turbulent(std::uint64_t seed, const glm::dvec3& point, int octaves);

} // namespace ffgpu::gallery
