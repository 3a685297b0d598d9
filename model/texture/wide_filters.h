// Filters that read more than two texels along an axis: FFGPU_texture_filter. They know 2-D
// textures of colours; any other kind is filtered as OpenGL says.
//
// Bicubic (Keys 1981, a = -1/2), where the texture is magnified by a linear filter: 4 x 4 texels
// with weights in 1024ths, the products summed exactly and rounded once.
//
// Rip-map (Simard and others 1994; McReynolds 1998): images that are halved along each axis on its
// own; model/device/filter_tables.h says where they lie. i and j with 8 fraction bits are the
// logarithms of what a pixel covers along u and along v: four images, bilinear in each, mixed as
// trilinear filtering mixes two.
//
// Summed-area table (Crow 1984): a sample is the mean over the axis-parallel box around what the
// pixel covers, one texel and more: exact, rounded once.
//
// Elliptic weighted average (Heckbert 1989): the pixel's circle of radius 1 becomes an ellipse
// among the texels of a level,
//
//     Q = A U^2 + B U V + C V^2 < F,  A = vx^2 + vy^2 + 1,  B = -2 (ux vx + uy vy),
//     C = ux^2 + uy^2 + 1,  F = A C - B^2 / 4
//
// and the texels in it are averaged with weights round(255 2^(-6 k / 128)), k = floor(128 Q / F);
// gaussian_weights.h says why.
// The level is that of anisotropic probes. A side of more than 32 texels counts as 32.
//
// Feline (McCormack and others 1999): that ellipse by probes of the mip map; feline_filter.cpp.

#pragma once

#include "model/device/filter_tables.h"
#include "model/texture/filter_witness.h"
#include "model/texture/level_of_detail.h"

#include <array>
#include <cstdint>

namespace ffgpu {

// Whether a filter of its own samples this quad.
bool is_wide(const TextureUnit& unit, const QuadSampling& quad);

// The sample of a unit and quad that is_wide().
Rgba filter_wide(const TextureUnit& unit,
                 const SampledFragment& fragment,
                 const QuadSampling& quad,
                 const FilterWitness& witness);

Rgba filter_bicubic(const TextureUnit&, const SampledFragment&, const FilterWitness&);
Rgba filter_rip_map(const TextureUnit&,
                    const SampledFragment&,
                    const QuadSampling&,
                    const FilterWitness&);
Rgba filter_summed_area(const TextureUnit&,
                        const SampledFragment&,
                        const QuadSampling&,
                        const FilterWitness&);
Rgba filter_elliptic(const TextureUnit&,
                     const SampledFragment&,
                     const QuadSampling&,
                     const FilterWitness&);
Rgba filter_feline(const TextureUnit&,
                   const SampledFragment&,
                   const QuadSampling&,
                   const FilterWitness&);

// The weights of texels -1, 0, 1 and 2 for a point `weight` 256ths of the way from texel 0 to 1, in
// 1024ths; their sum is 1024.
std::array<std::int32_t, 4> bicubic_weights(std::uint32_t weight);

} // namespace ffgpu
