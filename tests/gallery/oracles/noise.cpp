#include "tests/gallery/oracles/noise.h"

#include <cmath>
#include <numbers>

namespace ffgpu::gallery {
namespace {

std::uint64_t scramble(std::uint64_t z) {
    z = 0xbf58476d1ce4e5b9 * (z ^ z >> 30);
    z = 0x94d049bb133111eb * (z ^ z >> 27);
    return z ^ z >> 31;
}

// The gradient at a lattice point, times the offset from it.
double slope(std::uint64_t seed, const long lattice[3], const double offset[3]) {
    std::uint64_t hash = seed + 1;
    for (int i = 0; i < 3; ++i)
        hash = scramble(hash + static_cast<std::uint64_t>(lattice[i]));
    const double z = 2 * (static_cast<double>(hash >> 32) / 4294967296.0) - 1;
    const double turn =
        static_cast<double>(hash & 0xffffffff) / 4294967296.0 * 2 * std::numbers::pi;
    const double across = std::sqrt(1 - z * z);
    return across * (std::cos(turn) * offset[0] + std::sin(turn) * offset[1]) + z * offset[2];
}

} // namespace

std::uint64_t Draws::next() {
    counter_ += 0x9e3779b97f4a7c15;
    return scramble(counter_);
}

double Draws::unit() {
    return static_cast<double>(next() >> 11) / 9007199254740992.0;
}

double gradient_noise(std::uint64_t seed, const glm::dvec3& point) {
    double sum = 0;
    for (int corner = 0; corner < 8; ++corner) {
        long lattice[3];
        double offset[3], weight = 1;
        for (int i = 0; i < 3; ++i) {
            lattice[i] = static_cast<long>(std::floor(point[i])) + (corner >> i & 1);
            offset[i] = point[i] - static_cast<double>(lattice[i]);
            const double t = std::abs(offset[i]);
            weight *= 2 * t * t * t - 3 * t * t + 1;
        }
        sum += weight * slope(seed, lattice, offset);
    }
    return sum;
}

double turbulent(std::uint64_t seed, const glm::dvec3& point, int octaves) {
    double sum = 0;
    for (int i = 0; i < octaves; ++i)
        sum += std::ldexp(std::abs(gradient_noise(seed, std::ldexp(1.0, i) * point)), -i);
    return sum;
}

} // namespace ffgpu::gallery
