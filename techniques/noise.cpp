#include "techniques/noise.h"

#include "techniques/random.h"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace ffgpu::techniques {
namespace {

constexpr double TwoPi = 2 * std::numbers::pi;

int wrapped(int i, int period) {
    return period > 0 ? (i % period + period) % period : i;
}

} // namespace

std::vector<Wave> annulus_waves(std::uint64_t seed, int count, double inner, double outer) {
    Random random(seed);
    std::vector<Wave> waves;
    for (int i = 0; i < count; ++i) {
        const double radius = std::sqrt(random.between(inner * inner, outer * outer));
        const double direction = random.between(0, TwoPi);
        const double phase = random.between(0, TwoPi);
        waves.push_back(
            {{radius * std::cos(direction), radius * std::sin(direction)}, 1.0 / count, phase});
    }
    return waves;
}

double fourier(const std::vector<Wave>& waves, const glm::dvec2& point) {
    double sum = 0;
    for (const Wave& wave : waves)
        sum += wave.amplitude * std::cos(glm::dot(wave.frequency, point) + wave.phase);
    return sum;
}

double GradientNoise::weight(double t) {
    const double a = std::abs(t);
    return a < 1 ? (2 * a - 3) * a * a + 1 : 0;
}

glm::dvec3 GradientNoise::gradient(int x, int y, int z) const {
    std::uint64_t h = seed_ + 1;
    for (const int coordinate : {x, y, z}) {
        const int place = wrapped(coordinate, period_);
        h = Random::mix(h + static_cast<std::uint64_t>(static_cast<std::int64_t>(place)));
    }
    const double height = static_cast<double>(h >> 32) * 0x1p-31 - 1;
    const double turn = TwoPi * static_cast<double>(h & 0xffffffffu) * 0x1p-32;
    const double radius = std::sqrt(1 - height * height);
    return {radius * std::cos(turn), radius * std::sin(turn), height};
}

double GradientNoise::operator()(const glm::dvec3& point) const {
    const glm::dvec3 corner = glm::floor(point);
    double sum = 0;
    for (int i = 0; i < 8; ++i) {
        const glm::dvec3 lattice = corner + glm::dvec3(i & 1, i >> 1 & 1, i >> 2);
        const glm::dvec3 d = point - lattice;
        const glm::dvec3 g = gradient(
            static_cast<int>(lattice.x), static_cast<int>(lattice.y), static_cast<int>(lattice.z));
        sum += weight(d.x) * weight(d.y) * weight(d.z) * glm::dot(g, d);
    }
    return sum;
}

double turbulence(const GradientNoise& noise, const glm::dvec3& point, int octaves) {
    double sum = 0, scale = 1;
    for (int i = 0; i < octaves; ++i, scale *= 2)
        sum += std::abs(noise(scale * point)) / scale;
    return sum;
}

double stripe(const Stripes& stripes, const GradientNoise& noise, const glm::dvec3& point) {
    double phase = TwoPi * glm::dot(stripes.direction, point) / stripes.width;
    if (stripes.swing != 0) phase += stripes.swing * turbulence(noise, point, stripes.octaves);
    return (1 + std::sin(phase)) / 2;
}

} // namespace ffgpu::techniques
