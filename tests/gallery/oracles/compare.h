// A picture against its oracle.

#pragma once

#include "tests/gallery/oracles/oracle.h"

#include <cstdint>
#include <vector>

namespace ffgpu::gallery {

// RGB of 8 bits, rows from the bottom, WindowWidth x WindowHeight.
using Picture = std::vector<std::uint8_t>;

// Differences in units of 1/255: what lies outside of the oracle's values within its reach.
struct Difference {
    double worst = 0, rms = 0;
    double rms_at_centres = 0; // without any reach
    int worst_x = 0, worst_y = 0;
    Picture oracle; // its values at the pixels' centres
};

Difference difference(const Picture& picture, const Claim& claim);

inline bool holds(const Difference& difference, const Claim& claim) {
    return difference.worst <= claim.worst_allowed && difference.rms <= claim.rms_allowed;
}

} // namespace ffgpu::gallery
