// Reaction and diffusion (T22): two substances that spread and feed on each other grow into spots
// and stripes.
//
// Gray and Scott's reaction as Pearson 1993, "Complex Patterns in a Simple System", runs it:
//   du/dt = Du lap(u) - u v^2 + feed (1 - u)
//   dv/dt = Dv lap(v) + u v^2 - (feed + kill) v
// by explicit steps of time 1 on a torus; lap() is the sum of the four neighbours less four times
// the texel, lengths in texels.

#pragma once

#include "techniques/image.h"

#include <cstdint>

namespace ffgpu::techniques {

struct GrayScott {
    double spread_u = 0.16, spread_v = 0.08; // texels^2 a step; stable up to 1/4
    double feed = 0.035, kill = 0.060;       // a step
};

struct Reaction {
    Field u, v; // in [0, 1]
};

// u = 1 and v = 0, but for `spots` squares of side 2 half + 1 with u = 1/2, v = 1/4; their centres
// are two draws below(size) of Random(seed) each, x first.
Reaction seed_reaction(int size, std::uint64_t seed, int spots, int half);
void advance(Reaction& reaction, const GrayScott& rates, int steps);

} // namespace ffgpu::techniques
