// Ambient occlusion (T24): how much of an even sky each texel of a relief sees, made once and kept
// in a texture that is multiplied by the first.
//
// Of the horizon's elevation e(phi) seen from a point, the visible share weighted by the cosine is
// the mean over phi of cos^2 e(phi), for the surface's level normal (0, 0, 1). Source: Max 1988,
// "Horizon mapping: shadows for bump-mapped surfaces".

#pragma once

#include "techniques/image.h"

namespace ffgpu::techniques {

struct Horizon {
    int directions = 64; // azimuths, evenly spaced from half a step on
    int reach = 64;      // how far is looked, in texels
};

// In [0, 1] a texel: 1 sees the whole sky. Heights are in texel widths. The field does not repeat:
// beyond its edges is nothing. Along a direction the height is looked at in steps of one texel, and
// taken from the nearest texel, at that texel's own distance.
Field ambient_occlusion(const Field& heights, const Horizon& horizon);

} // namespace ffgpu::techniques
