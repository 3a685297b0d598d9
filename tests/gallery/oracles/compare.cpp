#include "tests/gallery/oracles/compare.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

namespace ffgpu::gallery {
namespace {

struct Range {
    Color centre, low, high;
};

Range values_around(const Oracle& oracle, const glm::dvec2& pixel, double reach) {
    const Color centre = oracle(pixel);
    Range range{centre, centre, centre};
    if (reach <= 0) return range;
    for (const glm::dvec2 corner : {glm::dvec2(1, 1), {1, -1}, {-1, 1}, {-1, -1}}) {
        const Color value = oracle(pixel + reach * corner);
        range.low = glm::min(range.low, value);
        range.high = glm::max(range.high, value);
    }
    return range;
}

std::uint8_t to_byte(double value) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 1.0) * 255));
}

} // namespace

Difference difference(const Picture& picture, const Claim& claim) {
    Difference result;
    result.oracle.resize(picture.size());
    const Oracle oracle = claim.oracle();
    double sum = 0, sum_at_centres = 0;
    for (std::size_t i = 0; i < picture.size(); ++i) {
        const auto pixel = static_cast<int>(i / 3);
        static thread_local Range range;
        const int x = pixel % WindowWidth, y = pixel / WindowWidth;
        if (i % 3 == 0) range = values_around(oracle, {x + 0.5, y + 0.5}, claim.reach);
        const auto channel = static_cast<int>(i % 3);
        const double value = picture[i];
        const double low = 255 * range.low[channel], high = 255 * range.high[channel];
        const double outside = std::max({0.0, low - value, value - high});
        const double at_centre = value - 255 * range.centre[channel];
        result.oracle[i] = to_byte(range.centre[channel]);
        sum += outside * outside;
        sum_at_centres += at_centre * at_centre;
        if (outside <= result.worst) continue;
        result.worst = outside;
        result.worst_x = x;
        result.worst_y = y;
    }
    result.rms = std::sqrt(sum / static_cast<double>(picture.size()));
    result.rms_at_centres = std::sqrt(sum_at_centres / static_cast<double>(picture.size()));
    return result;
}

} // namespace ffgpu::gallery
