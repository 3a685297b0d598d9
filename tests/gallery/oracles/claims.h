// What each row of the textbook claims: its formula, its tolerance, its oracle.

#pragma once

#include "tests/gallery/oracles/oracle.h"

namespace ffgpu::gallery {

Claim texel_lookup_claim();
Claim wrap_modes_claim();
Claim barycentric_interpolation_claim();
Claim perspective_correct_claim();
Claim magnification_claim();
Claim mip_pyramid_claim();
Claim level_of_detail_claim();
Claim mappings_claim();
Claim texgen_claim();
Claim projective_texture_claim();

} // namespace ffgpu::gallery
