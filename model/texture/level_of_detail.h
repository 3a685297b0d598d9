// Level of detail: one choice of levels, filter and probes for each quad.
//
// The derivatives are differences within the quad: lane 1 less lane 0 in x, lane 2 less lane 0 in
// y. They are the same for its four fragments, so that a quad needs one logarithm.

#pragma once

#include "model/arith/log2.h"
#include "model/texture/coordinates.h"
#include "model/texture/texture_unit.h"

#include <array>
#include <cstdint>

namespace ffgpu {

// What the coordinates change by from a pixel to the next.
struct CoordinateSteps {
    std::array<float, 3> x{}, y{};
};

// A step of this many texels is taken as 2^-60 or 2^60: squares stay ordinary numbers.
constexpr float LeastStep = 0x1p-60f;
constexpr float LargestStep = 0x1p60f;

// The squared lengths of a pixel's two sides in texels of level 0, as the bits of binary32
// numbers: not negative, so they compare as integers do.
struct PixelFootprint {
    std::uint32_t x = 0, y = 0;
};

// 512 log2(n), rounded down: what n probes take off the logarithm of a squared length.
constexpr auto ProbeLogarithms = [] {
    std::array<std::int32_t, MaxProbes + 1> table{};
    for (unsigned n = 1; n <= MaxProbes; ++n)
        table[n] = log2_fixed8(static_cast<float>(n * n));
    return table;
}();

// How the fragments of one quad are sampled.
struct QuadSampling {
    std::uint8_t level = 0;
    std::uint8_t next_level = 0; // used if weight != 0
    std::uint8_t weight = 0;     // of the next level, in 256ths
    bool linear = false;         // within a level
    std::uint8_t probes = 1;     // anisotropic samples, averaged
    TexCoord major_step;         // the coordinates' change over the pixel's longer side

    // From what it was chosen.
    CoordinateSteps steps;
    PixelFootprint footprint;
    std::int32_t lambda = 0;
};

PixelFootprint pixel_footprint(const TextureUnit& unit, const CoordinateSteps& steps);

// Samples along the longer side: the fewest that leave none longer than the shorter side, or than
// a texel of level 0 if that is more; by differences of logarithms.
unsigned count_probes(const PixelFootprint& footprint, unsigned most);

// lambda with 8 fraction bits: log2 of the longer side over the probes, biased and clamped.
std::int32_t
level_of_detail(const TextureUnit& unit, const PixelFootprint& footprint, unsigned probes);

// Fills level, next_level, weight and linear.
QuadSampling choose_levels(const TextureUnit& unit, std::int32_t lambda);

// Everything for the quad with these coordinates (of cube maps on one face).
// `one_face`: anisotropy is possible, the four fragments do not lie on several faces.
QuadSampling
sample_quad(const TextureUnit& unit, const std::array<TexCoord, 4>& lanes, bool one_face);

} // namespace ffgpu
